// From mid-exposure to swap on a made-up clock: two cameras of 30 Hz whose exposure, transfer and
// losses are drawn from a seed, a panel of 60 Hz, a consumer that is fast or slow.
#include "devices/newest_pair.hpp"
#include "tests/support/fake_source.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

using namespace autostereo;
using namespace autostereo::devices;
using namespace std::chrono_literals;

namespace {

constexpr Duration kPeriod = 33'333us, kRefresh = 16'667us;
constexpr Duration kJitter = 500us; ///< either way, of a mid-exposure
constexpr Duration kLeastExposure = 2ms, kMostExposure = 12ms;
constexpr Duration kLeastTransfer = 4ms, kMostTransfer = 9ms;
constexpr int kFrames = 4000;

/// What a picture takes to render.
struct Render {
    Duration least, most;
};
constexpr Render kFast{3ms, 5ms};
constexpr Render kSlow{kPeriod * 5 / 2, kPeriod * 7 / 2}; ///< three periods on average
struct Shot {
    PixelFormat format;
    TimePoint capturedAt, arrivesAt;
};

class Dice {
  public:
    explicit Dice(std::uint32_t seed) : random_(seed) {}
    Duration between(Duration least, Duration most) {
        return least + Duration(static_cast<Duration::rep>(
                           static_cast<double>((most - least).count()) * uniform()));
    }
    bool happens(double share) { return uniform() < share; }

  private:
    double uniform() { return static_cast<double>(random_() >> 8) * 0x1p-24; }
    std::mt19937 random_;
};

struct Case {
    double phase;    ///< of colour behind depth, periods
    double loss = 0; ///< share of each camera's frames
    std::uint32_t seed = 1;
};

std::vector<Shot> shotsOf(const Case& c) {
    Dice dice(c.seed);
    std::vector<Shot> shots;
    const auto later = Duration(std::llround(c.phase * static_cast<double>(kPeriod.count())));
    for (const auto format : {PixelFormat::Depth16, PixelFormat::Rgba8})
        for (int i = 0; i < kFrames; ++i) {
            const Duration nominal = 1s + i * kPeriod + dice.between(-kJitter, kJitter);
            const TimePoint captured(nominal + (format == PixelFormat::Rgba8 ? later : Duration{}));
            const TimePoint arrives = captured + dice.between(kLeastExposure, kMostExposure) / 2 +
                                      dice.between(kLeastTransfer, kMostTransfer);
            if (!dice.happens(c.loss)) shots.push_back({format, captured, arrives});
        }
    std::ranges::stable_sort(shots, {}, &Shot::arrivesAt);
    return shots;
}

struct Picked {
    TimePoint depthAt, colorAt, at, swapAt;
};

/// The daemon's loop: take what is newest, render it, swap at the panel's next refresh.
std::vector<Picked> play(const std::vector<Shot>& shots, Render render) {
    Dice dice(7);
    FramePool pool(kFramesOnTheWay * 2);
    NewestPair pairs(SyncParams{});
    std::vector<Picked> picked;
    std::size_t next = 0;
    TimePoint now;
    while (next < shots.size()) {
        for (; next < shots.size() && shots[next].arrivesAt <= now; ++next) {
            Frame frame = test::tinyFrame(pool, shots[next].format, shots[next].capturedAt);
            if (frame.empty()) throw std::runtime_error("more frames are kept than the pool holds");
            frame.metadata().arrivedAt = shots[next].arrivesAt;
            const bool depth = shots[next].format == PixelFormat::Depth16;
            (depth ? pairs.depth() : pairs.color()).push(std::move(frame));
        }
        if (const auto pair = pairs.take(now)) {
            const auto ticks =
                (now + dice.between(render.least, render.most)).time_since_epoch() / kRefresh + 1;
            const TimePoint swapAt(ticks * kRefresh);
            picked.push_back({pair->depth.metadata().capturedAt, pair->color.metadata().capturedAt,
                              now, swapAt});
            now = swapAt;
        } else if (next < shots.size()) {
            now = std::min(shots[next].arrivesAt, pairs.ripeAt().value_or(TimePoint::max()));
        }
    }
    return picked;
}

double ms(Duration duration) { return std::chrono::duration<double, std::milli>(duration).count(); }

/// Milliseconds from mid-exposure to the swap, or until the pair was taken to be rendered.
double percentile99(const std::vector<Picked>& picked, TimePoint Picked::*until) {
    std::vector<double> ages;
    ages.reserve(picked.size());
    for (const Picked& one : picked)
        ages.push_back(ms(one.*until - one.depthAt));
    const auto at = ages.begin() + static_cast<std::ptrdiff_t>(ages.size() * 99 / 100);
    std::ranges::nth_element(ages, at);
    return *at;
}

/// From mid-exposure until a pair can be complete, at worst: the second half of the exposure, the
/// transfer, and the other camera's mid-exposure, half a period and both cameras' jitter later.
constexpr Duration kUntilComplete = kMostExposure / 2 + kMostTransfer + kPeriod / 2 + 2 * kJitter;

class NewestPairPhases : public testing::TestWithParam<double> {};

TEST_P(NewestPairPhases, FromMidExposureToSwapTakesItsPartsAndNoMore) {
    for (const double loss : {0.0, 0.002}) {
        const auto picked = play(shotsOf({.phase = GetParam(), .loss = loss}), kFast);
        EXPECT_GT(picked.size(), (0.999 - 3 * loss) * kFrames); // a picture for all but every pair
        EXPECT_LE(percentile99(picked, &Picked::swapAt), ms(kUntilComplete + kFast.most + kRefresh))
            << "loss " << loss;
    }
}

/// Beside that its own rendering takes longer: what it takes is a frame older at most.
TEST_P(NewestPairPhases, ASlowConsumerAddsAFrameAtMost) {
    const auto shots = shotsOf({.phase = GetParam(), .loss = 0.002});
    const double fast = percentile99(play(shots, kFast), &Picked::at);
    const double slow = percentile99(play(shots, kSlow), &Picked::at);
    EXPECT_LE(slow, fast + ms(kPeriod));
}

/// The definition, by looking at all frames that were there: a depth frame may be passed over for
/// an older one only while it can still hope for a nearer partner, half a period at most, or has
/// none.
bool passesOver(const Picked& one, const std::vector<Shot>& shots) {
    const auto begin = // what arrived before can have no part in it
        std::ranges::lower_bound(shots, one.depthAt - kPeriod, {}, &Shot::arrivesAt);
    const auto end = std::ranges::upper_bound(shots, one.at, {}, &Shot::arrivesAt);
    return std::any_of(begin, end, [&](const Shot& depth) {
        const bool couldBeShown = depth.format == PixelFormat::Depth16 &&
                                  depth.capturedAt > one.depthAt &&
                                  depth.arrivesAt + kPeriod / 2 + kJitter <= one.at;
        return couldBeShown && std::any_of(begin, end, [&](const Shot& color) {
                   return color.format == PixelFormat::Rgba8 && color.capturedAt > one.colorAt &&
                          std::chrono::abs(color.capturedAt - depth.capturedAt) <=
                              SyncParams{}.tolerance;
               });
    });
}

TEST_P(NewestPairPhases, NothingThatIsReadyIsPassedOver) {
    for (const Render& render : {kFast, kSlow, Render{4 * kPeriod, 9 * kPeriod}})
        for (const std::uint32_t seed : {1U, 2U, 3U}) {
            const auto shots = shotsOf({.phase = GetParam(), .loss = 0.05, .seed = seed});
            for (const Picked& one : play(shots, render))
                ASSERT_FALSE(passesOver(one, shots))
                    << "at " << ms(one.at.time_since_epoch()) << " ms, seed " << seed
                    << ", rendered in " << ms(render.least) << " ms or more";
        }
}

INSTANTIATE_TEST_SUITE_P(Colour, NewestPairPhases,
                         testing::Values(0.0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875),
                         [](const auto& phase) {
                             return "Later" + std::to_string(std::lround(1000 * phase.param));
                         });

TEST(NewestPair, OfAllThatIsThereTheNearestIsTaken) {
    FramePool pool(4);
    NewestPair pairs(SyncParams{});
    const TimePoint asked(1s); // everything has waited long enough by then
    for (const Duration color : {0ms, 20ms})
        pairs.color().push(test::tinyFrame(pool, PixelFormat::Rgba8, TimePoint(color)));
    pairs.depth().push(test::tinyFrame(pool, PixelFormat::Depth16, TimePoint(12ms)));
    const auto pair = pairs.take(asked);
    ASSERT_TRUE(pair);
    EXPECT_EQ(pair->color.metadata().capturedAt, TimePoint(20ms));
}

} // namespace
