// Numbers, stamps and silences of frames, with invented times.

#include "devices/sequence_counter.hpp"
#include "devices/silence_watch.hpp"
#include "devices/v4l2/frame_clock.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

namespace autostereo {
namespace {

using namespace devices::v4l2;
using namespace std::chrono_literals;
using devices::Duration;
using devices::SequenceCounter;
using devices::SilenceWatch;
using devices::TimePoint;

constexpr std::uint32_t kLast = std::numeric_limits<std::uint32_t>::max();

TEST(SequenceCounter, GapsAreLostFramesAndWrapsAreNot) {
    SequenceCounter counter;
    EXPECT_EQ(counter.map(kLast - 1), 0U);
    EXPECT_EQ(counter.map(kLast), 1U);
    EXPECT_EQ(counter.map(0), 2U);
    EXPECT_EQ(counter.map(3), 5U);
    EXPECT_EQ(counter.lost(), 2U);
}

TEST(SequenceCounter, StartingAgainLosesNothing) {
    SequenceCounter counter(100);
    EXPECT_EQ(counter.map(7), 100U);
    EXPECT_EQ(counter.map(0), 101U);
    EXPECT_EQ(counter.map(0), 102U);
    EXPECT_EQ(counter.map(500'000), 103U);
    EXPECT_EQ(counter.lost(), 0U);
}

TEST(FrameClock, StampsBecomeTheMiddleOfTheExposure) {
    FrameClock clock;
    const TimePoint now(100s);
    const Duration stamp = 100s - 20ms;
    EXPECT_EQ(clock.midExposure(stamp, StampOf::ExposureStart, 10ms, now), TimePoint(stamp + 5ms));
    EXPECT_EQ(clock.midExposure(stamp, StampOf::ReceptionStart, 10ms, now), TimePoint(stamp - 5ms));
    EXPECT_EQ(clock.midExposure(stamp, StampOf::FrameEnd, 10ms, now), TimePoint(stamp - 5ms));
    EXPECT_EQ(clock.shifts(), 0U);
    // vivid stamps frames up to a period ahead.
    EXPECT_EQ(clock.midExposure(100s + 30ms, StampOf::FrameEnd, 0ms, now), now);
}

TEST(FrameClock, AnotherClockIsShiftedOnceAndThenFollowed) {
    FrameClock clock;
    for (int i = 0; i < 100; ++i) {
        // Arrival jitters by milliseconds; the stamps do not.
        const TimePoint now(100s + i * 33ms + i % 7 * 1ms);
        const TimePoint time = clock.midExposure(i * 33ms, StampOf::FrameEnd, 0ms, now);
        EXPECT_EQ(time, TimePoint(100s + i * 33ms));
    }
    EXPECT_EQ(clock.shifts(), 1U);
}

TEST(FrameClock, WrapsAndExtremesAreSurvived) {
    FrameClock clock;
    TimePoint now(1000s);
    EXPECT_EQ(clock.midExposure(1000s, StampOf::FrameEnd, 0ms, now), now);
    for (const Duration stamp :
         {Duration::max() - 1ms, Duration::min(), Duration::max(), Duration(-1), Duration(0)}) {
        now += 33ms;
        const TimePoint time = clock.midExposure(stamp, StampOf::FrameEnd, 0ms, now);
        EXPECT_LE(time, now);
        EXPECT_GE(time, now - 500ms);
    }
}

TEST(SilenceWatch, TwoSecondsForTheFirstFrameThenFivePeriods) {
    SilenceWatch watch;
    const TimePoint start(10s);
    watch.start(start, 40ms);
    EXPECT_EQ(watch.deadline(), start + 2s);
    watch.frame(start + 1s, 0ms);
    EXPECT_EQ(watch.deadline(), start + 1s + 200ms);
    watch.frame(start + 1s, 100ms); // in the dark the exposure is longer than the period
    EXPECT_EQ(watch.deadline(), start + 1s + 500ms);
}

TEST(SilenceWatch, ACameraSlowerThanItSaysIsNotRestartedForEver) {
    SilenceWatch watch;
    TimePoint now(10s);
    int restarts = 0;
    for (int i = 0; i < 20; ++i) { // says 30 frames a second, gives 4
        watch.start(now, 33ms);
        watch.frame(now, 0ms);
        now += 250ms;
        if (now < watch.deadline()) break;
        watch.expired();
        ++restarts;
    }
    EXPECT_EQ(restarts, 1);
    // Nor is one that gives a frame every three seconds, as it says.
    watch.start(now, 3s);
    watch.frame(now, 0ms);
    EXPECT_GT(watch.deadline(), now + 3s);
}

} // namespace
} // namespace autostereo
