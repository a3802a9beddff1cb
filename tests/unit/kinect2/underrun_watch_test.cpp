// Whether a stream may have been without transfers, with invented times.

#include "devices/kinect2/usb/underrun_watch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <random>

namespace autostereo {
namespace {

using devices::Duration;
using devices::TimePoint;
using devices::kinect2::UnderrunWatch;
using namespace std::chrono_literals;

constexpr auto kSpan = 4ms;
constexpr int kTransfers = 12;

TEST(UnderrunWatch, AQueueLastsAsLongAsItsTransfers) {
    UnderrunWatch watch(kSpan);
    for (int i = 0; i < kTransfers; ++i)
        EXPECT_FALSE(watch.submitted(TimePoint(1s), TimePoint(1s)));
    UnderrunWatch copy = watch;
    // 48 ms less 0.2 %, less the lead.
    EXPECT_FALSE(watch.submitted(TimePoint(1'044'900us), TimePoint(1'044'900us)));
    EXPECT_TRUE(copy.submitted(TimePoint(1'044'900us), TimePoint(1'044'910us)));
}

TEST(UnderrunWatch, ALongWayIntoTheKernelIsLate) {
    UnderrunWatch watch(kSpan);
    for (int i = 0; i < kTransfers; ++i)
        EXPECT_FALSE(watch.submitted(TimePoint(1s), TimePoint(1s)));
    EXPECT_TRUE(watch.submitted(TimePoint(1'001ms), TimePoint(1'060ms)));
}

TEST(UnderrunWatch, AFailedTransferMayHaveEndedAtOnce) {
    UnderrunWatch watch(kSpan);
    for (int i = 0; i < kTransfers; ++i)
        EXPECT_FALSE(watch.submitted(TimePoint(1s), TimePoint(1s)));
    for (int i = 0; i < kTransfers; ++i)
        watch.failed(TimePoint(1'001ms));
    EXPECT_TRUE(watch.submitted(TimePoint(1'001ms), TimePoint(1'001ms)));
    for (int i = 1; i < kTransfers; ++i)
        static_cast<void>(watch.submitted(TimePoint(1'001ms), TimePoint(1'001ms)));
    EXPECT_FALSE(watch.submitted(TimePoint(1'004ms), TimePoint(1'004ms)));
}

/// A bus, its kernel and a reader that is kept waiting. Transfers run one behind the other, each
/// from its submission or its predecessor's end, whichever is later.
class Bus {
  public:
    Bus(Duration span, Duration pauses, unsigned seed)
        : span_(span), pauses_(pauses), random_(seed) {
        for (int i = 0; i < kTransfers; ++i)
            submit();
    }
    /// The reader's turn: looks, waits for the next end, takes all that have ended and sends them
    /// again.
    void turn() {
        if (told_.front() > now_) watch_.noneEnded(now_, kTransfers);
        pass(20us);
        now_ = std::max(now_, told_.front());
        sometimesPause(50);
        while (told_.front() <= now_) {
            told_.pop_front();
            pass(300us); // for its bytes
            sometimesPause(300);
            submit();
        }
    }

    int gaps = 0, missed = 0, early = 0, submissions = 0;

  private:
    void pass(Duration atMost) {
        now_ += Duration(std::uniform_int_distribution<Duration::rep>(0, atMost.count())(random_));
    }
    void sometimesPause(unsigned every) {
        if (random_() % every == 0) pass(pauses_);
    }
    void submit() {
        const TimePoint before = now_;
        sometimesPause(300);
        const bool gap = !told_.empty() && now_ > end_;
        const Duration left = end_ - now_;
        end_ = std::max(end_, now_) + span_;
        // The kernel may be late to tell, but not always.
        const Duration late = random_() % 4 == 0 ? pauses_ / 2 : Duration(0);
        told_.push_back(std::max(end_ + late, told_.empty() ? end_ : told_.back()));
        pass(20us);
        const bool called = watch_.submitted(before, now_);
        ++submissions;
        gaps += gap ? 1 : 0;
        missed += gap && !called ? 1 : 0;
        // Two transfers and what the bound loses by and by: 0.35 % of a second.
        early += called && left > 2 * kSpan + UnderrunWatch::kLead + 4ms ? 1 : 0;
    }

    Duration span_, pauses_;
    std::mt19937_64 random_;
    UnderrunWatch watch_{kSpan};
    TimePoint now_{1s};
    TimePoint end_{};              ///< of the queue
    std::deque<TimePoint> told_{}; ///< when the reader hears of each one's end
};

TEST(UnderrunWatch, MissesNoneOnAnyBusThatDrifts) {
    int gaps = 0;
    for (const double drift : {-0.0015, -0.0005, 0.0, 0.0005, 0.0015})
        for (const Duration pauses : {Duration(30ms), Duration(60ms), Duration(200ms)}) {
            const auto span = static_cast<Duration::rep>((1 + drift) * Duration(kSpan).count());
            Bus bus(Duration(span), pauses, 7);
            while (bus.submissions < 200'000) // a quarter of an hour
                bus.turn();
            EXPECT_EQ(bus.missed, 0) << drift;
            EXPECT_LE(bus.early, bus.submissions / 1000) << drift;
            gaps += bus.gaps;
        }
    EXPECT_GT(gaps, 1000);
}

TEST(UnderrunWatch, CallsNothingLateOnAQuietBus) {
    for (const double drift : {-0.0005, 0.0, 0.0005}) {
        UnderrunWatch watch(kSpan);
        const auto span =
            Duration(static_cast<Duration::rep>((1 + drift) * Duration(kSpan).count()));
        for (int i = 0; i < kTransfers; ++i)
            EXPECT_FALSE(watch.submitted(TimePoint(1s), TimePoint(1s)));
        for (TimePoint time(1s); time < TimePoint(3600s);) {
            watch.noneEnded(time, kTransfers);
            time += span;
            ASSERT_FALSE(watch.submitted(time, time)) << drift;
        }
    }
}

} // namespace
} // namespace autostereo
