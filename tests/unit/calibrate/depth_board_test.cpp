// A board in the depth camera's own measurements.

#include "calib/solve/depth_board.hpp"
#include "calib/solve/pose_solver.hpp"
#include "tests/unit/calibrate/simulated_boards.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace autostereo::calibrate {
namespace {

/// How far a camera's measurements are off, metres.
struct Off {
    double at1M = 0, perMetre = 0, dark = 0, noise = 0;
};

bool isDark(const glm::dvec2& onBoard) {
    const auto column = static_cast<int>(std::floor(onBoard.x / kSimulatedBoard.squareM));
    const auto row = static_cast<int>(std::floor(onBoard.y / kSimulatedBoard.squareM));
    return (row + column) % 2 != 0;
}

/// The board's plane as depth camera measures it, tenths of a millimetre; ray by ray.
DepthPicture measured(SimulatedBoards& simulated, const calib::CameraModel& camera,
                      const calib::RigidTransform& cameraFromBoard, const Off& off) {
    const calib::Intrinsics& size = camera.intrinsics;
    DepthPicture picture{size.width, size.height, 1e-4, {}, {}};
    const glm::dvec3 normal = cameraFromBoard.rotation[2];
    const double distance = glm::dot(normal, cameraFromBoard.translation);
    const calib::RigidTransform boardFromCamera = cameraFromBoard.inverse();
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const auto ray = camera.unproject({x, y});
            double z = ray ? distance / glm::dot(normal, glm::dvec3(*ray, 1)) : 0;
            const bool hits = z > 0.2 && z < 6;
            const glm::dvec3 point = hits ? z * glm::dvec3(*ray, 1) : glm::dvec3(0);
            const bool dark = hits && isDark(boardFromCamera * point);
            z += off.at1M + off.perMetre * (z - 1) + (dark ? 0.5 : -0.5) * off.dark +
                 simulated.gaussian(off.noise);
            picture.counts.push_back(hits ? static_cast<std::uint16_t>(std::lround(1e4 * z)) : 0);
            picture.amplitudes.push_back(dark ? 300 : 900);
        }
    return picture;
}

struct Scene {
    explicit Scene(std::uint32_t seed, int count, double noisePx, const Off& off)
        : simulated(seed), rig(simulated.rig()),
          seen(simulated.views(rig, kSimulatedBoard, count, noisePx, 0.7, 2.0, 0.5)) {
        for (std::size_t i = 0; i < seen.poses.size(); ++i)
            pictures.push_back(measured(simulated, rig.depth, seen.poses[i], off));
    }
    SimulatedBoards simulated;
    calib::SensorRig rig;
    SimulatedBoards::Seen seen;
    std::vector<DepthPicture> pictures;
};

std::optional<DepthBias> biasIn(const Scene& scene) {
    std::vector<DepthBoard> boards;
    for (std::size_t i = 0; i < scene.pictures.size(); ++i)
        boards.push_back({&scene.seen.views.depth[i], &scene.pictures[i]});
    return depthBias(scene.rig.depth, kSimulatedBoard, boards);
}

TEST(DepthBoard, BiasIsFound) {
    const Off off{.at1M = 0.012, .perMetre = 0.005, .dark = 0.003, .noise = 0.002};
    const Scene scene(3, 8, 0.1, off);
    const auto found = biasIn(scene);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->views, 8U);
    // Corners to 0.1 px place a board of half a metre at 2 m to 2 mm.
    EXPECT_NEAR(found->atOneMetreM, off.at1M, std::fmax(0.001, found->at95M));
    EXPECT_NEAR(found->perMetreM, off.perMetre, 0.003);
    EXPECT_NEAR(found->darkM, off.dark, 0.001);
    EXPECT_GT(found->farthestM, found->nearestM);
}

TEST(DepthBoard, NoBiasWithoutMeasurements) {
    Scene scene(4, 4, 0.1, {});
    for (std::size_t i = 0; i < 2; ++i)
        scene.pictures[i].counts.assign(scene.pictures[i].counts.size(), 0);
    EXPECT_FALSE(biasIn(scene)) << "two views are too few";
}

TEST(DepthBoard, PointsPlaceTheColorCamera) {
    Scene scene(5, 10, 0.2, {.noise = 0.002});
    auto& spoilt = scene.pictures[0].counts; // a wall behind, 30 mm farther
    for (std::uint16_t& count : spoilt)
        count = static_cast<std::uint16_t>(count + 300);
    std::vector<PointPixel> points;
    for (const auto& [d, c] : scene.seen.views.pairs)
        for (const PointPixel& point :
             pointsOf(scene.rig.depth, scene.pictures[d], scene.seen.views.depth[d],
                      scene.seen.views.color[c], {}))
            points.push_back(point);
    EXPECT_EQ(points.size(), 10U * 54);
    const PoseFit fit = solvePose(scene.rig.color, points, 3);
    EXPECT_LT(
        1e3 * glm::distance(fit.cameraFromPoints.translation, scene.rig.colorFromDepth.translation),
        2);
}

TEST(DepthBoard, BetweenPixelsOfOneSurfaceOnly) {
    DepthPicture picture{2, 2, 1e-3, {1000, 1010, 1000, 1010}, {}};
    EXPECT_NEAR(picture.at({0.5, 0.5}).value_or(0), 2 / (1 / 1.0 + 1 / 1.010), 1e-12);
    EXPECT_FALSE(picture.at({-0.1, 0.5}));
    EXPECT_FALSE(picture.at({1.5, 0.5}));
    picture.counts[3] = 0;
    EXPECT_FALSE(picture.at({0.5, 0.5})) << "no measurement";
    picture.counts[3] = 1500;
    EXPECT_FALSE(picture.at({0.5, 0.5})) << "an edge";
}

} // namespace
} // namespace autostereo::calibrate
