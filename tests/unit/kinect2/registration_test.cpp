#include "devices/kinect2/registration.hpp"

#include "tests/support/kinect2_unit.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace autostereo::test {
namespace {

using namespace devices::kinect2;

/// The factory's formula as published, term by term, from the page's own numbers: the column and
/// row of the colour picture for an undistorted depth pixel counted from the optical axis.
std::array<double, 2> publishedFormula(const Kinect2Unit& unit, double fromAxisX, double fromAxisY,
                                       double depthMm) {
    const double mx = fromAxisX * 0.01, my = fromAxisY * 0.01;
    const auto polynomial = [&](const std::array<float, 10>& c) {
        return std::pow(mx, 3) * c[0] + std::pow(my, 3) * c[1] + mx * mx * my * c[2] +
               my * my * mx * c[3] + mx * mx * c[4] + my * my * c[5] + mx * my * c[6] + mx * c[7] +
               my * c[8] + c[9];
    };
    const double wx = polynomial(unit.xTerms), wy = polynomial(unit.yTerms);
    const double rx = wx / (unit.colorFocal * 0.002199) - unit.displacementMm / unit.nominalDepthMm;
    return {(rx + unit.displacementMm / depthMm) * unit.colorFocal + unit.colorCx,
            wy / 0.002199 + unit.colorCy};
}

ColorCalibration colorOf(const Kinect2Unit& unit) { return parseColorPage(colorPage(unit)); }
DepthCamera depthOf(const Kinect2Unit& unit) { return parseDepthCameraPage(depthCameraPage(unit)); }

TEST(Registration, ReproducesTheFactorysPolynomial) {
    const Kinect2Unit unit = inventedUnit();
    const auto color = colorOf(unit);
    const auto depth = depthOf(unit);
    for (const double depthMm : {500.0, 863.0, 2000.0, 8000.0})
        for (int y = 0; y < kHeight; y += 47)
            for (int x = 1; x < kWidth; x += 51) {
                const auto ray = rayOf(unit, x, y);
                const auto expected =
                    publishedFormula(unit, ray[0] * unit.fx, ray[1] * unit.fy, depthMm);
                const auto pixel = colorPixel(color, depth, {ray[0], ray[1]}, depthMm);
                // Both in double precision; 0.01 px is allowed.
                ASSERT_NEAR(pixel.x, expected[0], 1e-6);
                ASSERT_NEAR(pixel.y, expected[1], 1e-6);
            }
}

/// Check points on a wall; centroids of the depth picture with or without its distortion.
Kinect2Unit withCheckPoints(bool distorted, double errorPx) {
    Kinect2Unit unit = inventedUnit();
    for (int row = 0; row < 23; ++row)
        for (int column = 0; column < 28; ++column) {
            const int x = 20 + 17 * column, y = 20 + 17 * row;
            const auto ray = rayOf(unit, x, y);
            const auto r = static_cast<std::size_t>(row), c = static_cast<std::size_t>(column);
            const double straightX = ray[0] * unit.fx, straightY = ray[1] * unit.fy;
            const auto seen = publishedFormula(unit, straightX, straightY, 900);
            unit.irCentroids[r][c] =
                distorted ? ColorCalibration::Point{static_cast<float>(x) + 0.5F,
                                                    static_cast<float>(y) + 0.5F}
                          : ColorCalibration::Point{static_cast<float>(straightX + unit.cx),
                                                    static_cast<float>(straightY + unit.cy)};
            unit.colorCentroids[r][c] = {static_cast<float>(seen[0] + errorPx),
                                         static_cast<float>(seen[1])};
            unit.checkDepthsMm[r][c] = 900;
        }
    return unit;
}

TEST(Registration, ReportsTheCheckPointsResidual) {
    for (const bool distorted : {true, false})
        for (const double error : {0.0, 0.75}) {
            const Kinect2Unit unit = withCheckPoints(distorted, error);
            const auto check = checkRegistration(colorOf(unit), depthOf(unit));
            EXPECT_EQ(check.points, 644);
            EXPECT_EQ(check.withoutDistortion, !distorted);
            // The page holds floats: 1e-4 px at column 1920.
            EXPECT_NEAR(check.rmsPx, error, 2e-3);
            EXPECT_NEAR(check.worstPx, error, 5e-3);
        }
}

TEST(Registration, CheckPointsThatTheFactoryDidNotFindAreLeftOut) {
    Kinect2Unit unit = withCheckPoints(true, 0);
    unit.checkDepthsMm[3].fill(0);
    unit.colorCentroids[5][5] = {NAN, 0};
    EXPECT_EQ(checkRegistration(colorOf(unit), depthOf(unit)).points, 644 - 28 - 1);
    EXPECT_EQ(checkRegistration(colorOf(inventedUnit()), depthOf(inventedUnit())).points, 0);
}

TEST(Registration, APinholeCameraIsFoundAgain) {
    Kinect2Unit unit = inventedUnit();
    unit.xTerms = {0, 0, 0, 0, 0, 0, 0, 0.65F, 0, 0.03F};
    unit.yTerms = {0, 0, 0, 0, 0, 0, 0, 0, 0.65F, -0.02F};
    const FittedRig fitted = fitRig(colorOf(unit), depthOf(unit));
    EXPECT_LT(fitted.worstPx, 1e-3);
    // By hand: pixels per unit of x/z, and the baseline that makes the factory's parallax of them.
    const double focal = unit.fx * 0.01 * 0.65 / 0.002199;
    EXPECT_NEAR(fitted.rig.color.intrinsics.fx, focal, 0.5);
    EXPECT_NEAR(fitted.rig.colorFromDepth.translation.x, 52e-3 * unit.colorFocal / focal, 1e-4);
    EXPECT_NEAR(fitted.rig.colorFromDepth.translation.y, 0, 1e-4);
}

TEST(Registration, TheRigMeetsThePolynomial) {
    const Kinect2Unit unit = inventedUnit();
    const auto color = colorOf(unit);
    const auto depth = depthOf(unit);
    const FittedRig fitted = fitRig(color, depth);
    std::printf("rig against polynomial: rms %.4f px, worst %.4f px\n", fitted.rmsPx,
                fitted.worstPx);
    EXPECT_LT(fitted.rmsPx, 0.5);
    // And says so truly, between the points of the fit too.
    const auto ray = rayOf(unit, 300, 100);
    const glm::dvec3 point{ray[0] * 1.1, ray[1] * 1.1, 1.1};
    const auto seen = fitted.rig.color.project(fitted.rig.colorFromDepth * point);
    const auto expected = colorPixel(color, depth, {ray[0], ray[1]}, 1100);
    ASSERT_TRUE(seen);
    EXPECT_LE(std::hypot(seen->x - expected.x, seen->y - expected.y), fitted.worstPx);
}

} // namespace
} // namespace autostereo::test
