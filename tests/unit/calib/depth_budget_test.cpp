#include "calib/depth_budget.hpp"
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

constexpr PlacementLimits kWide{0.05, 100, 0, 10};

DisparityLaw lawOf(const DepthPlacement& placement, double framingWidth) {
    return disparityLaw(panel(), placement.focusM, framingWidth * placement.focusM,
                        placement.scale);
}

TEST(PlacementFor, FillsTheBudgetAndKeepsInsideIt) {
    RandomNumbers random(31);
    int nearBinds = 0, farBinds = 0;
    for (int round = 0; round < 1000; ++round) {
        const double subject = random.between(0.5, 4), width = random.between(0.5, 2);
        const SceneDepths scene{subject * random.between(0.3, 1), subject,
                                subject * random.between(1, 6)};
        const DepthPlacement placement = placementFor(scene, panel(), width, kWide);
        EXPECT_EQ(placement.focusM, subject);
        const DisparityLaw law = lawOf(placement, width);
        const auto [nearest, farthest] = unclampedDepths(law);
        EXPECT_LE(nearest, scene.nearM + 1e-9);
        EXPECT_GE(farthest, scene.farM - 1e-9);
        const bool nearIsFull = std::abs(nearest - scene.nearM) < 1e-9;
        const bool farIsFull = std::abs(farthest - scene.farM) < 1e-9;
        EXPECT_TRUE(nearIsFull || farIsFull || placement.scale == 10) << "depth is given away";
        nearBinds += nearIsFull ? 1 : 0;
        farBinds += farIsFull ? 1 : 0;
    }
    EXPECT_GT(nearBinds, 50);
    EXPECT_GT(farBinds, 50);
}

TEST(PlacementFor, LimitsHoldWhateverTheSceneIs) {
    constexpr PlacementLimits kLimits{0.6, 2, 0.4, 0.9};
    RandomNumbers random(32);
    for (int round = 0; round < 1000; ++round) {
        const double subject = random.between(0.05, 50);
        const DepthPlacement placement = placementFor(
            {subject * random.between(0, 1), subject, subject * random.between(1, 100)}, panel(),
            random.between(0.2, 3), kLimits);
        EXPECT_GE(placement.focusM, 0.6);
        EXPECT_LE(placement.focusM, 2);
        EXPECT_GE(placement.scale, 0.4);
        EXPECT_LE(placement.scale, 0.9);
    }
    const DepthPlacement fixed = placementFor({1, 2, 3}, panel(), 1, {1.25, 1.25, 0.7, 0.7});
    EXPECT_EQ(fixed, (DepthPlacement{1.25, 0.7}));
}

TEST(PlacementFor, AFlatSceneMayHaveAllTheDepthThereIs) {
    EXPECT_EQ(placementFor({2, 2, 2}, panel(), 1, kWide).scale, 10);
}

TEST(PlacementFor, OnAWideFanNoDepthIsTooFar) {
    DisplayProfile display = panel();
    display.disparityFar = -1; // the fan's half width is 0.49: behind the panel d > -0.49
    EXPECT_EQ(placementFor({1, 1, 1e6}, display, 1, kWide).scale, 10);
}

PlacementFollower follower() { return PlacementFollower({2, 0.1}); }

TEST(PlacementFollower, TheFirstGoalIsReachedAtOnce) {
    auto follow = follower();
    EXPECT_FALSE(follow.placement());
    EXPECT_EQ(follow.follow({1.3, 0.6}, 0), (DepthPlacement{1.3, 0.6}));
}

TEST(PlacementFollower, RestsExactlyInsideTheDeadBand) {
    auto follow = follower();
    static_cast<void>(follow.follow({1.5, 0.8}, 0));
    RandomNumbers random(33);
    for (int frame = 0; frame < 500; ++frame)
        EXPECT_EQ(follow.follow(
                      {1.5 * random.between(0.92, 1.09), 0.8 * random.between(0.92, 1.09)}, 0.033),
                  (DepthPlacement{1.5, 0.8}));
}

TEST(PlacementFollower, MovesWithItsTimeConstantAndThenRests) {
    auto follow = follower();
    static_cast<void>(follow.follow({2, 0.5}, 0));
    const DepthPlacement goal{1, 1};
    for (int frame = 0; frame < 100; ++frame) // 2 s: one time constant
        static_cast<void>(follow.follow(goal, 0.02));
    const double left = std::exp(-1.0);
    EXPECT_NEAR(std::log2(follow.placement()->focusM), left, 1e-9);
    EXPECT_NEAR(std::log2(follow.placement()->scale), -left, 1e-9);
    for (int frame = 0; frame < 1000; ++frame)
        static_cast<void>(follow.follow(goal, 0.02));
    const DepthPlacement rest = *follow.placement();
    EXPECT_NEAR(rest.focusM, 1, 0.011);
    EXPECT_EQ(follow.follow(goal, 0.02), rest);
    EXPECT_EQ(follow.follow({1.05, 1}, 0.02), rest) << "inside the dead band again";
}

/// However frames fall, time decides.
TEST(PlacementFollower, DoesNotDependOnTheFrameRate) {
    auto slow = follower(), fast = follower();
    static_cast<void>(slow.follow({3, 1}, 0));
    static_cast<void>(fast.follow({3, 1}, 0));
    for (int i = 0; i < 10; ++i)
        static_cast<void>(slow.follow({1, 1}, 0.1));
    for (int i = 0; i < 100; ++i)
        static_cast<void>(fast.follow({1, 1}, 0.01));
    EXPECT_NEAR(slow.placement()->focusM, fast.placement()->focusM, 1e-9);
}

TEST(PlacementFollower, OddTimesDoNoHarm) {
    auto follow = follower();
    static_cast<void>(follow.follow({2, 1}, 0));
    EXPECT_EQ(follow.follow({1, 1}, -5).focusM, 2);
    EXPECT_EQ(follow.follow({1, 1}, std::numeric_limits<double>::quiet_NaN()).focusM, 2);
    EXPECT_GT(follow.follow({1, 1}, 1e9).focusM, 1.5) << "a pause is no leap";
    EXPECT_EQ(follow.follow({1, 0}, 0.1).scale, 0);
    EXPECT_EQ(follow.follow({1, 0.5}, 0.1).scale, 0.5);
}

} // namespace
} // namespace autostereo::calib
