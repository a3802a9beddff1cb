#include "devices/clock_map.hpp"

#include <gtest/gtest.h>

#include <random>

namespace autostereo::test {
namespace {

using namespace devices;
using namespace std::chrono_literals;

constexpr Duration kPeriod = 33ms;

/// Frames stamped by a device whose clock began at `offset` of the host's, each delayed by 2 to
/// 12 ms. Largest and smallest result minus the true time, without the first 30.
struct Spread {
    Duration least = 1h, most = -1h;
};
Spread spreadOf(double drift, int frames) {
    ClockMap map;
    std::mt19937 random(1);
    std::uniform_int_distribution<int> delayUs(2000, 12000);
    Spread spread;
    TimePoint last{};
    for (int i = 0; i < frames; ++i) {
        const TimePoint taken{1000s + i * kPeriod};
        const Duration device{
            static_cast<Duration::rep>(static_cast<double>((i * kPeriod).count()) * (1 + drift))};
        const TimePoint arrived = taken + std::chrono::microseconds(delayUs(random));
        const TimePoint result = map.map(device, arrived);
        EXPECT_LE(result, arrived);
        EXPECT_GE(result, last);
        last = result;
        if (i < 30) continue;
        spread.least = std::min(spread.least, result - taken);
        spread.most = std::max(spread.most, result - taken);
    }
    return spread;
}

TEST(ClockMap, DelaysThatVaryDoNotMatter) {
    const Spread spread = spreadOf(0, 3000);
    EXPECT_GE(spread.least, 2ms);
    // The shortest of 30 delays, and creeping up until the next short one.
    EXPECT_LE(spread.most, 3ms);
}

TEST(ClockMap, FollowsClocksThatDrift) {
    for (const double drift : {50e-6, -50e-6}) {
        const Spread spread = spreadOf(drift, 30000); // 17 minutes: 50 ms apart at the end
        EXPECT_GE(spread.least, 1900us);
        EXPECT_LE(spread.most, 4ms);
    }
}

TEST(ClockMap, StartsAnewWhereTheDevicesClockJumps) {
    ClockMap map;
    const TimePoint start{100s};
    EXPECT_EQ(map.map(5s, start), start);
    EXPECT_EQ(map.map(5s + kPeriod, start + kPeriod), start + kPeriod);
    EXPECT_EQ(map.map(0s, start + 2 * kPeriod), start + 2 * kPeriod) << "back to its beginning";
    EXPECT_EQ(map.map(1h, start + 3 * kPeriod), start + 3 * kPeriod) << "far ahead";
    EXPECT_EQ(map.map(1h + kPeriod, start + 4 * kPeriod), start + 4 * kPeriod);
    EXPECT_EQ(map.map(1h - 200ms, start + 5 * kPeriod), start + 5 * kPeriod) << "a little back";
}

} // namespace
} // namespace autostereo::test
