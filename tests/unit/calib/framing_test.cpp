#include "calib/framing.hpp"
#include "tests/unit/calib/random_numbers.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace autostereo::calib {
namespace {

constexpr double kDegree = 0.017453292519943295;

/// Cameras side by side in one housing, a few degrees askew, as RGB-D devices are built.
SensorRig randomRig(RandomNumbers& random) {
    SensorRig rig;
    rig.depth = random.camera(0.3);
    rig.color = random.camera(0.3);
    rig.colorFromDepth = random.pose(6 * kDegree, 0.04);
    return rig;
}

/// How far a pixel lies outside the picture's outermost pixel centres; negative: inside.
double outside(const CameraModel& camera, const glm::dvec2& pixel) {
    return std::max({-pixel.x, pixel.x - (camera.intrinsics.width - 1), -pixel.y,
                     pixel.y - (camera.intrinsics.height - 1)});
}

/// Largest `outside` of the border of [-m, 1 + m] x [0, 1] in both cameras, at colour depth z.
double worstOverhang(const SensorRig& rig, const Framing& framing, double m, double z) {
    const RigidTransform depthFromColor = rig.colorFromDepth.inverse();
    double worst = -1e9;
    const auto visit = [&](double u, double v) {
        const glm::dvec2 ray = framing.rayFromPanel({u, v});
        const glm::dvec3 point{ray.x * z, ray.y * z, z};
        const auto inColor = rig.color.project(point);
        const auto inDepth = rig.depth.project(depthFromColor * point);
        worst = inColor && inDepth
                    ? std::max({worst, outside(rig.color, *inColor), outside(rig.depth, *inDepth)})
                    : 1e9;
    };
    for (int i = 0; i <= 200; ++i) {
        const double t = i / 200.0;
        visit(-m + t * (1 + 2 * m), 0);
        visit(-m + t * (1 + 2 * m), 1);
        visit(-m, t);
        visit(1 + m, t);
    }
    return worst;
}

/// Fisheyes may have no model at their pictures' edges: the panel shows what it knows.
TEST(Framing, EndsWhereTheLensModelDoes) {
    SensorRig rig;
    rig.depth = {{640, 480, 500, 500, 319.5, 239.5}, {}};
    rig.color = {{640, 480, 100, 100, 319.5, 239.5}, {}};
    rig.color.distortion.metricRadius = 0.5; // the picture reaches 3.2 to either side
    for (const bool depthToo : {false, true}) {
        if (depthToo) rig.depth = rig.color;
        const Framing framing = framePanel(rig, 1.5, 0.05, 1);
        EXPECT_GT(framing.width, 0.3);
        EXPECT_LE(framing.width * 1.1, 1.0);
        EXPECT_NEAR(framing.left + framing.width / 2, 0, 1e-9);
    }
}

TEST(Framing, BothCamerasCoverItWithItsOverscan) {
    RandomNumbers random(10);
    double tightest = -1e9;
    for (int round = 0; round < 300; ++round) {
        const SensorRig rig = randomRig(random);
        const double m = random.between(0, 0.1), focus = random.between(0.4, 3);
        const Framing framing = framePanel(rig, random.between(0.5, 1.8), m, focus);
        const double worst = worstOverhang(rig, framing, m, focus);
        // The pictures' bent edges are sampled at 33 places: the sag between two is left over.
        EXPECT_LT(worst, 0.1) << "round " << round << ", focus " << focus;
        for (const double times : {0.5, 5.0})
            EXPECT_LT(worstOverhang(rig, framing, m, times * focus), 0.1) << "round " << round;
        tightest = std::max(tightest, worst);
    }
    EXPECT_GT(tightest, -3) << "no rig is framed tightly: pixels are wasted";
}

TEST(Framing, KeepsThePanelsShape) {
    RandomNumbers random(11);
    for (int round = 0; round < 100; ++round) {
        const double aspect = random.between(0.4, 2.5);
        const Framing framing =
            framePanel(randomRig(random), aspect, random.between(0, 0.1), random.between(0.4, 3));
        EXPECT_NEAR(framing.width / framing.height, aspect, 1e-12);
        EXPECT_GT(framing.width, 0);
    }
}

TEST(Framing, IsTheLargestThatFits) {
    SensorRig rig;
    rig.color = {{641, 481, 500, 500, 320, 240}, {}};
    rig.depth = {{641, 641, 250, 250, 320, 320}, {}}; // sees far more
    const Framing wide = framePanel(rig, 2, 0.1, 1);
    EXPECT_NEAR(wide.width, 1.28 / 1.2, 1e-12); // the colour picture's width less the overscan
    EXPECT_NEAR(wide.left, -0.64 / 1.2, 1e-12);
    EXPECT_NEAR(wide.bottom, wide.height / 2, 1e-12);
    const Framing tall = framePanel(rig, 0.5, 0.1, 1);
    EXPECT_NEAR(tall.height, 0.96, 1e-12);
    EXPECT_NEAR(tall.bottom, 0.48, 1e-12);

    // A depth camera of the same view 0.1 m to the right: at half the focus it misses 0.2.
    rig.depth = rig.color;
    rig.colorFromDepth.translation = {0.1, 0, 0};
    const Framing moved = framePanel(rig, 2, 0, 1);
    EXPECT_NEAR(moved.left, -0.44, 1e-12);
    EXPECT_NEAR(moved.left + moved.width, 0.64, 1e-12 + 0.1 / 100); // at 100 m: 1 mm
}

TEST(Framing, ShowsTheColourPictureWhereTheCamerasLookApart) {
    SensorRig rig;
    rig.color = rig.depth = {{641, 481, 500, 500, 320, 240}, {}};
    const Framing alone = framePanel(rig, 4.0 / 3, 0, 1);
    rig.colorFromDepth.translation = {5, 0, 0};
    const Framing apart = framePanel(rig, 4.0 / 3, 0, 1);
    EXPECT_EQ(apart.left, alone.left);
    EXPECT_EQ(apart.width, alone.width);
}

TEST(Framing, PanelUpIsImageUp) {
    const Framing framing{-0.5, 0.4, 1, 0.8};
    EXPECT_LT(framing.rayFromPanel({0.5, 1}).y, framing.rayFromPanel({0.5, 0}).y);
    EXPECT_LT(framing.rayFromPanel({0, 0.5}).x, framing.rayFromPanel({1, 0.5}).x);
    const glm::dvec2 bottomLeft = framing.rayFromPanel({0, 0});
    EXPECT_DOUBLE_EQ(bottomLeft.x, -0.5);
    EXPECT_DOUBLE_EQ(bottomLeft.y, 0.4);
}

TEST(Framing, RaysAndPanelPlacesAreInverse) {
    RandomNumbers random(12);
    for (int i = 0; i < 100; ++i) {
        const double width = random.between(0.2, 2);
        const Framing framing{random.between(-1, 0), random.between(0, 1), width, width / 1.6};
        const glm::dvec2 uv{random.between(-0.2, 1.2), random.between(-0.2, 1.2)};
        const glm::dvec2 back = framing.panelFromRay(framing.rayFromPanel(uv));
        EXPECT_NEAR(back.x, uv.x, 1e-13);
        EXPECT_NEAR(back.y, uv.y, 1e-13);
    }
}

/// A camera turned clockwise by a quarter sees the world's right at its picture's top.
TEST(Framing, TurnsThePictureUpright) {
    SensorRig rig;
    rig.color = rig.depth = {{641, 481, 500, 500, 320, 240}, {}};
    const glm::dvec2 right{0.1, 0}, up{0, -0.1};
    const auto shown = [&](int quarterTurns, const glm::dvec2& ray) {
        const Framing framing = framePanel(rig, 1, 0, 1, {quarterTurns, false, 1, {0, 0}});
        return framing.panelFromRay(ray) - framing.panelFromRay({0, 0});
    };
    const auto expectAlong = [](const glm::dvec2& step, double x, double y) {
        EXPECT_NEAR(step.x, 0.1 / 0.96 * x, 1e-12);
        EXPECT_NEAR(step.y, 0.1 / 0.96 * y, 1e-12);
    };
    expectAlong(shown(0, right), 1, 0);
    expectAlong(shown(1, right), 0, -1);
    expectAlong(shown(1, up), 1, 0);
    expectAlong(shown(2, right), -1, 0);
    expectAlong(shown(2, up), 0, -1);
    expectAlong(shown(3, right), 0, 1);
}

TEST(Framing, AMirrorExchangesLeftAndRightOnly) {
    SensorRig rig;
    rig.color = rig.depth = {{641, 481, 500, 500, 300, 250}, {}};
    for (int turns = 0; turns < 4; ++turns) {
        const Framing plain = framePanel(rig, 1.5, 0.05, 1, {turns, false, 1, {0, 0}});
        const Framing mirror = framePanel(rig, 1.5, 0.05, 1, {turns, true, 1, {0, 0}});
        for (const glm::dvec2 ray : {glm::dvec2{0.1, 0.2}, {-0.3, 0.05}}) {
            EXPECT_NEAR(mirror.panelFromRay(ray).x, 1 - plain.panelFromRay(ray).x, 1e-12);
            EXPECT_NEAR(mirror.panelFromRay(ray).y, plain.panelFromRay(ray).y, 1e-12);
        }
    }
}

TEST(Framing, HoweverMountedBothCamerasCoverItWithItsOverscan) {
    RandomNumbers random(13);
    for (int round = 0; round < 300; ++round) {
        const SensorRig rig = randomRig(random);
        const double m = random.between(0, 0.1), aspect = random.between(0.5, 1.8);
        const FramingChoice choice{round % 4,
                                   round % 8 > 3,
                                   random.between(1, 4),
                                   {random.between(-1, 1), random.between(-1, 1)}};
        const Framing framing = framePanel(rig, aspect, m, 1.5, choice);
        EXPECT_NEAR(framing.width / framing.height, aspect, 1e-12);
        for (const double z : {0.75, 1.5, 7.5})
            EXPECT_LT(worstOverhang(rig, framing, m, z), 0.1) << "round " << round;
        const glm::dvec2 uv{random.between(0, 1), random.between(0, 1)};
        EXPECT_NEAR(glm::length(framing.panelFromRay(framing.rayFromPanel(uv)) - uv), 0, 1e-12);
    }
}

TEST(Framing, ZoomsAndPansToTheEndsOfWhatIsCovered) {
    SensorRig rig;
    rig.color = rig.depth = {{641, 481, 500, 500, 320, 240}, {}};
    const Framing all = framePanel(rig, 4.0 / 3, 0, 1);
    const auto at = [&](double x, double y) {
        return framePanel(rig, 4.0 / 3, 0, 1, {0, false, 2, {x, y}});
    };
    EXPECT_NEAR(at(0, 0).width, all.width / 2, 1e-12);
    EXPECT_NEAR(at(-1, 0).left, -0.64, 1e-12);
    EXPECT_NEAR(at(1, 0).left + at(1, 0).width, 0.64, 1e-12);
    EXPECT_NEAR(at(0, -1).bottom, 0.48, 1e-12);
    EXPECT_NEAR(at(0, 1).bottom - at(0, 1).height, -0.48, 1e-12);
}

} // namespace
} // namespace autostereo::calib
