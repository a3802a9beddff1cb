#include "calib/panel_map.hpp"
#include "calib/phase_laws.hpp"
#include "tests/unit/calib/random_numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace autostereo::calib {
namespace {

constexpr std::uint32_t kLastPhase = 0xffffffff;

DisplayProfile profile(int views, Fan fan = Fan::Centres) {
    DisplayProfile display;
    display.views = views;
    display.fan = fan;
    return display;
}

TEST(ViewMap, PhaseIsWithinOneUnitOfLongDouble) {
    RandomNumbers random(7);
    constexpr int kWidth = 7680, kHeight = 4320;
    for (int round = 0; round < 10; ++round) {
        DisplayProfile display = profile(48);
        LinearPhase law;
        law.perColumn = random.between(-1, 1);
        law.perRow = random.between(-1, 1);
        law.channels = {{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)}};
        law.offset = random.between(-100, 100);
        display.law = law;
        const ViewMap map = makeViewMap(display, kWidth, kHeight);
        long double worst = 0;
        for (int i = 0; i < 100'000; ++i) {
            const int x = static_cast<int>(random.between(0, kWidth));
            const int y = static_cast<int>(random.between(0, kHeight)), c = i % 3;
            const long double cycles = static_cast<long double>(law.perColumn) * x +
                                       static_cast<long double>(law.perRow) * y +
                                       law.channels[0].at(static_cast<std::size_t>(c)) + law.offset;
            const long double off = std::ldexp(static_cast<long double>(map.phase(x, y, c)), -32);
            worst = std::max(worst, std::abs(off - cycles - std::round(off - cycles)));
        }
        // Half a unit of 2^-32 twice, and 2^-49 for each column and row: 12,000 * 2^-49 < 2^-35.
        EXPECT_LE(worst, std::ldexp(1.0L, -32) + std::ldexp(1.0L, -35));
        EXPECT_GT(worst, std::ldexp(1.0L, -34)) << "too good for 32 bits: is it compared at all?";
    }
}

TEST(ViewMap, EveryPhaseHasAViewAndEveryViewItsShare) {
    for (const int views : {1, 2, 5, 8, 48, 100, 1000}) {
        const ViewMap map = makeViewMap(profile(views), 1, 1);
        const auto n = static_cast<std::uint32_t>(views);
        EXPECT_EQ(map.view(0), 0U);
        EXPECT_EQ(map.view(kLastPhase), n - 1);
        for (std::uint32_t view = 0; view < n; ++view) {
            // First phase of a view, exactly: ceil(view 2^32 / n).
            const auto first = ((std::uint64_t{view} << 32) + n - 1) / n;
            EXPECT_EQ(map.view(static_cast<std::uint32_t>(first)), view);
            if (view > 0) {
                EXPECT_EQ(map.view(static_cast<std::uint32_t>(first - 1)), view - 1);
            }
        }
    }
}

TEST(ViewMap, ReversedOrderCountsFromTheOtherEnd) {
    DisplayProfile display = profile(8);
    display.law = VanBerkelLens{8, 1, 0};
    const ViewMap forward = makeViewMap(display, 16, 16);
    display.order = ViewOrder::RightToLeft;
    const ViewMap backward = makeViewMap(display, 16, 16);
    EXPECT_EQ(forward.view(forward.phase(0, 0, 0)), 0U);
    EXPECT_EQ(backward.view(backward.phase(0, 0, 0)), 7U);
    for (int y = 0; y < 16; ++y)
        for (int k = 0; k < 48; ++k) {
            const std::uint32_t phase = forward.phase(k / 3, y, k % 3);
            ASSERT_EQ(backward.phase(k / 3, y, k % 3), phase);
            EXPECT_EQ(forward.view(phase) + backward.view(phase), 7U);
        }
}

TEST(ViewMap, OneViewIsEverywhereAndInTheMiddle) {
    DisplayProfile display = profile(1);
    LinearPhase law;
    law.perColumn = 0.3;
    law.perRow = 0.7;
    law.channels = {{0, 0.1, 0.2}};
    law.offset = 0.9;
    display.law = law;
    for (const ViewOrder order : {ViewOrder::LeftToRight, ViewOrder::RightToLeft}) {
        display.order = order;
        const ViewMap map = makeViewMap(display, 20, 20);
        for (int y = 0; y < 20; ++y)
            for (int x = 0; x < 20; ++x)
                EXPECT_EQ(map.view(map.phase(x, y, 1)), 0U);
    }
    EXPECT_EQ(viewPosition(profile(1, Fan::Centres), 0), 0);
    EXPECT_EQ(viewPosition(profile(1, Fan::Edges), 0), 0);
}

TEST(ViewPosition, CentresOfTheirShareOfTheFan) {
    EXPECT_DOUBLE_EQ(viewPosition(profile(2), 0), -0.5);
    EXPECT_DOUBLE_EQ(viewPosition(profile(2), 1), 0.5);
    EXPECT_DOUBLE_EQ(viewPosition(profile(5), 0), -0.8);
    EXPECT_DOUBLE_EQ(viewPosition(profile(5), 2), 0);
    EXPECT_DOUBLE_EQ(viewPosition(profile(5), 4), 0.8);
    for (int view = 0; view < 48; ++view)
        EXPECT_NEAR(viewPosition(profile(48), view), (view - 23.5) / 24, 1e-15);
}

TEST(ViewPosition, EdgesReachTheEndsOfTheFan) {
    EXPECT_DOUBLE_EQ(viewPosition(profile(2, Fan::Edges), 0), -1);
    EXPECT_DOUBLE_EQ(viewPosition(profile(2, Fan::Edges), 1), 1);
    EXPECT_DOUBLE_EQ(viewPosition(profile(5, Fan::Edges), 1), -0.5);
    for (int view = 0; view < 48; ++view)
        EXPECT_NEAR(viewPosition(profile(48, Fan::Edges), view), (view - 23.5) / 23.5, 1e-15);
}

} // namespace
} // namespace autostereo::calib
