// Pictures and cameras turned round; JPEGs likewise, without loss.

#include "devices/kinect2/mirror.hpp"

#include "devices/kinect2/registration.hpp"
#include "devices/replay/jpeg_decoder.hpp"
#include "devices/replay/jpeg_mirror.hpp"
#include "tests/support/kinect2_unit.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <string>

namespace autostereo::test {
namespace {

using namespace devices::kinect2;

TEST(Mirror, ASceneSeenInAMirrorIsSeenTheRightWayRound) {
    Kinect2Unit unit = inventedUnit();
    unit.p1 = 0.0011F;
    unit.p2 = -0.0007F;
    const auto fitted =
        fitRig(parseColorPage(colorPage(unit)), parseDepthCameraPage(depthCameraPage(unit))).rig;
    const auto turned = mirrored(fitted);
    EXPECT_LT(turned.colorFromDepth.translation.x, 0) << "the colour camera is on the right";
    for (const glm::dvec3 point : {glm::dvec3(0.3, -0.2, 1), glm::dvec3(-0.5, 0.4, 2.5)}) {
        const glm::dvec3 other(-point.x, point.y, point.z);
        const auto depth = fitted.depth.project(point), depthTurned = turned.depth.project(other);
        const auto color = fitted.color.project(fitted.colorFromDepth * point);
        const auto colorTurned = turned.color.project(turned.colorFromDepth * other);
        ASSERT_TRUE(depth && depthTurned && color && colorTurned);
        EXPECT_NEAR(depthTurned->x, 511 - depth->x, 1e-9);
        EXPECT_NEAR(depthTurned->y, depth->y, 1e-9);
        EXPECT_NEAR(colorTurned->x, 1919 - color->x, 1e-9);
        EXPECT_NEAR(colorTurned->y, color->y, 1e-9);
    }
}

TEST(Mirror, RowsAreReversed) {
    std::array<std::uint32_t, 6> pixels{1, 2, 3, 4, 5, 6};
    mirrorRows(pixels, 3);
    EXPECT_EQ(pixels, (std::array<std::uint32_t, 6>{3, 2, 1, 6, 5, 4}));
}

TEST(Mirror, WhatIsNoJpegIsRefused) {
    const std::string text = "no JPEG";
    EXPECT_THROW(static_cast<void>(devices::mirroredJpeg(std::as_bytes(std::span(text)))),
                 std::runtime_error);
    EXPECT_THROW(static_cast<void>(devices::mirroredJpeg({})), std::runtime_error);
}

} // namespace
} // namespace autostereo::test
