// The camera's clock on the host's, with invented times.

#include "devices/kinect2/unit_clock.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace autostereo {
namespace {

using devices::TimePoint;
using devices::kinect2::UnitClock;
using namespace std::chrono_literals;

constexpr auto kHalfFrame = 16'666'666ns;

TEST(UnitClock, TheEarliestArrivalTiesTheClocks) {
    UnitClock clock;
    // 800 units are 100 ms; frames are late by 5, 2 and 9 ms.
    EXPECT_EQ(clock.depth(1000, TimePoint(10'005ms)), TimePoint(10'005ms) - kHalfFrame);
    EXPECT_EQ(clock.depth(1800, TimePoint(10'102ms)), TimePoint(10'102ms) - kHalfFrame);
    // The tie creeps by 100 us a second at most.
    const auto third = clock.depth(2600, TimePoint(10'209ms)) + kHalfFrame;
    EXPECT_GE(third, TimePoint(10'202ms));
    EXPECT_LE(third, TimePoint(10'202ms) + 10us);
}

TEST(UnitClock, ColourFollowsTheCamerasClockAcrossTheWrap) {
    UnitClock clock;
    static_cast<void>(clock.depth(0xfffffff0, TimePoint(20s)));
    // 32 units later are 4 ms; exposed for 10 ms, arrived long after.
    EXPECT_EQ(clock.color(0x10, 10, TimePoint(20'040ms)), TimePoint(19'999ms));
    // Before the depth frame.
    EXPECT_EQ(clock.color(0xffffffe8, 0, TimePoint(20'040ms)), TimePoint(19'999ms));
    // And so does depth.
    EXPECT_EQ(clock.depth(0x90, TimePoint(20'020ms)), TimePoint(20'020ms) - kHalfFrame);
}

TEST(UnitClock, NonsenseCountsByArrival) {
    UnitClock clock;
    EXPECT_EQ(clock.color(5, 0, TimePoint(7s)), TimePoint(7s)) << "no depth yet";
    static_cast<void>(clock.depth(1000, TimePoint(30s)));
    EXPECT_EQ(clock.color(1000 + 80'000, 0, TimePoint(31s)), TimePoint(31s)) << "10 s ahead";
    EXPECT_EQ(clock.color(1000, NAN, TimePoint(31s)), TimePoint(30s));
    EXPECT_EQ(clock.color(1000, 1e30F, TimePoint(31s)), TimePoint(30s) - 50ms);
    EXPECT_EQ(clock.color(1000 + 800, 0, TimePoint(30s + 50ms)), TimePoint(30s + 50ms))
        << "never later than it came";
}

} // namespace
} // namespace autostereo
