#include "calib/disparity_law.hpp"
#include "tests/unit/calib/random_numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace autostereo::calib {
namespace {

DisplayProfile panel() {
    DisplayProfile display;
    display.widthM = 0.5;
    display.viewingDistanceM = 0.8;
    display.coneRad = 0.6;
    display.disparityFar = -0.05;
    display.disparityNear = 0.03;
    return display;
}

/// By similar triangles in display space: where the rays from the eyes at 0 and at b = 1 through
/// a point at height Z meet the panel, in panel widths.
double byTriangles(const DisplayProfile& display, double height) {
    const double eye = display.viewingDistanceM * std::tan(display.coneRad / 2);
    const double seen =
        eye + (0 - eye) * display.viewingDistanceM /
                  (display.viewingDistanceM - height); // from the eye through (0, Z)
    return -seen / display.widthM;
}

TEST(DisparityLaw, FollowsTheGeometryInsideTheBudget) {
    const DisplayProfile display = panel();
    const DisparityLaw law = disparityLaw(display, 1.5, 1.25, 0.8);
    EXPECT_DOUBLE_EQ(law.scale, 0.8 * 0.5 / 1.25);
    EXPECT_DOUBLE_EQ(law.fanHalfWidth, 0.8 * std::tan(0.3) / 0.5);
    RandomNumbers random(8);
    int inside = 0;
    for (int i = 0; i < 1000; ++i) {
        const double z = random.between(1.2, 2);
        const double free = byTriangles(display, law.scale * (1.5 - z));
        inside += free > -0.05 && free < 0.03;
        EXPECT_NEAR(law.disparity(z), std::clamp(free, -0.05, 0.03), 1e-14) << z;
    }
    EXPECT_GT(inside, 200);
    EXPECT_LT(inside, 1000);
}

TEST(DisparityLaw, NearIsPositiveAndTheFocusStaysPut) {
    const DisparityLaw law = disparityLaw(panel(), 1.5, 1.25, 1);
    EXPECT_EQ(law.disparity(1.5), 0);
    EXPECT_GT(law.disparity(1.49), 0);
    EXPECT_LT(law.disparity(1.51), 0);
}

TEST(DisparityLaw, StaysInTheBudget) {
    const DisparityLaw law = disparityLaw(panel(), 1.5, 1.25, 1);
    EXPECT_EQ(law.disparity(0.5), 0.03);
    EXPECT_EQ(law.disparity(1000), -0.05);
    EXPECT_EQ(law.disparity(1e9), -0.05);
}

TEST(DisparityLaw, AtOrBehindTheEyeIsNearest) {
    DisparityLaw law = disparityLaw(panel(), 3, 0.5, 1); // scale 1: the eye is at z = 2.2
    law.nearest = 1e9;
    EXPECT_GT(law.disparity(2.3), 0);
    EXPECT_LT(law.disparity(2.3), 10);
    for (const double z : {2.1999, 1.0, 0.0, -5.0})
        EXPECT_EQ(law.disparity(z), 1e9) << z;
}

TEST(DisparityLaw, KnowsWhatTheBudgetDoesNotClamp) {
    const DisparityLaw law = disparityLaw(panel(), 1.5, 1.25, 0.8);
    const auto [nearest, farthest] = unclampedDepths(law);
    EXPECT_NEAR(law.disparity(nearest + 1e-6), 0.03, 1e-6);
    EXPECT_LT(law.disparity(nearest + 1e-6), 0.03);
    EXPECT_NEAR(law.disparity(farthest - 1e-6), -0.05, 1e-6);
    EXPECT_GT(law.disparity(farthest - 1e-6), -0.05);
    EXPECT_TRUE(std::isinf(unclampedDepths(disparityLaw(panel(), 1.5, 1.25, 0)).farthestM));
}

TEST(DisparityLaw, NeverGrowsWithDistance) {
    RandomNumbers random(9);
    for (int round = 0; round < 50; ++round) {
        const DisparityLaw law = disparityLaw(panel(), random.between(0.3, 5),
                                              random.between(0.3, 5), random.between(0.2, 3));
        double before = std::numeric_limits<double>::infinity();
        for (double z = 0.01; z < 12; z += 0.01) {
            const double now = law.disparity(z);
            ASSERT_LE(now, before) << "z = " << z;
            before = now;
        }
        EXPECT_LT(before, 0);
    }
}

} // namespace
} // namespace autostereo::calib
