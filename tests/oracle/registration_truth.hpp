#pragma once

#include "calib/sensor_rig.hpp"
#include "devices/sim/scene_view.hpp"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

// What a perfect registration would answer, by casting rays into the simulated scene. Independent
// of meshes, triangles and GL.

namespace autostereo::oracle {

/// How far from the axis (z = 1 plane) a lens model stays one to one: where its derivative along
/// and across the radius is still a tenth.
inline double oneToOneRadius(const calib::Distortion& lens) {
    constexpr double kStep = 0.01, kMost = 2, kDelta = 1e-6;
    for (double r = kStep; r < kMost; r += kStep)
        for (double angle = 0; angle < 2 * std::numbers::pi; angle += 0.1) {
            const glm::dvec2 at{r * std::cos(angle), r * std::sin(angle)};
            const glm::dvec2 bent = distort(lens, at);
            const glm::dvec2 dx = (distort(lens, at + glm::dvec2{kDelta, 0}) - bent) / kDelta;
            const glm::dvec2 dy = (distort(lens, at + glm::dvec2{0, kDelta}) - bent) / kDelta;
            if (!(dx.x * dy.y - dx.y * dy.x > 0.1)) return r - kStep;
        }
    return kMost;
}

/// Two cameras 100 mm apart and turned by 10 degrees against each other, all eight terms of both
/// lenses' distortion strong; a field of 70 degrees (depth) and 75 (colour) before it.
inline calib::SensorRig randomRig(std::uint32_t seed, int depthWidth, int depthHeight,
                                  int colorWidth, int colorHeight) {
    std::mt19937 engine(seed);
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine);
    };
    const auto camera = [&](int width, int height, double focal) {
        calib::CameraModel model{{width, height, focal * width, focal * width * between(0.99, 1.01),
                                  width * between(0.47, 0.53), height * between(0.47, 0.53)},
                                 {between(-0.3, 0.3), between(-0.1, 0.1), between(-0.005, 0.005),
                                  between(-0.005, 0.005), between(-0.03, 0.03), between(0, 0.2),
                                  between(0, 0.1), between(0, 0.03)}};
        model.distortion.metricRadius = oneToOneRadius(model.distortion);
        return model;
    };
    const auto direction = [&] {
        const double angle = between(0, 2 * std::numbers::pi);
        return glm::normalize(glm::dvec3{std::cos(angle), std::sin(angle), 0.3 * between(-1, 1)});
    };
    calib::SensorRig rig;
    rig.depth = camera(depthWidth, depthHeight, 0.714);
    rig.color = camera(colorWidth, colorHeight, 0.652);
    constexpr double kTilt = 10 * std::numbers::pi / 180, kBaselineM = 0.1;
    rig.colorFromDepth = {glm::mat3_cast(glm::angleAxis(kTilt, direction())),
                          kBaselineM * direction()};
    return rig;
}

/// One pixel of the colour camera.
struct TruePixel {
    double z = 0;      ///< metres along the colour camera's axis; 0: no ray
    bool seen = false; ///< by the depth camera too, inside its picture
    bool calm = false; ///< and no depth edge nor anything unseen close by
};

/// Counts of millimetres as a noise-free sensor gives them; 0 where a pixel has no ray.
inline std::vector<std::uint16_t> exactCounts(const devices::sim::Snapshot& scene,
                                              const calib::SensorRig& rig,
                                              const calib::RigidTransform& sceneFromColor) {
    std::vector<std::uint16_t> counts;
    for (int y = 0; y < rig.depth.intrinsics.height; ++y)
        for (int x = 0; x < rig.depth.intrinsics.width; ++x) {
            const auto hit =
                hitAtPixel(scene, rig.depth, sceneFromColor * rig.colorFromDepth, {x, y});
            const double millimetres = hit ? 1000 * hit->distance : 0;
            counts.push_back(
                static_cast<std::uint16_t>(std::lround(std::min(millimetres, 65534.0))));
        }
    return counts;
}

/// Whether the depth camera sees a point of the scene.
inline bool isSeenBy(const devices::sim::Snapshot& scene, const calib::CameraModel& camera,
                     const calib::RigidTransform& sceneFromCamera, const glm::dvec3& point) {
    const auto pixel = camera.project(sceneFromCamera.inverse() * point);
    const calib::Intrinsics& picture = camera.intrinsics;
    if (!pixel || pixel->x < -0.5 || pixel->y < -0.5 || pixel->x > picture.width - 0.5 ||
        pixel->y > picture.height - 0.5)
        return false;
    constexpr double kRounding = 1e-6; // of the way: the same surface
    const glm::dvec3 origin = sceneFromCamera.translation;
    return scene.trace({origin, point - origin}).distance > 1 - kRounding;
}

/// Clears `calm` near depth edges (neighbours differ by more than 2 %) and near what is not seen.
inline void markCalm(std::vector<TruePixel>& pixels, int width, int height, int reach) {
    const auto at = [&](int x, int y) -> TruePixel& {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    };
    const auto differs = [](const TruePixel& a, const TruePixel& b) {
        return std::abs(a.z - b.z) > 0.02 * std::min(a.z, b.z);
    };
    std::vector<std::uint8_t> rows(pixels.size());
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const TruePixel& own = at(x, y);
            const bool edge = !own.seen || (x + 1 < width && differs(own, at(x + 1, y))) ||
                              (y + 1 < height && differs(own, at(x, y + 1)));
            if (!edge) continue;
            for (int i = std::max(0, x - reach); i <= std::min(width - 1, x + reach); ++i)
                rows[static_cast<std::size_t>(&at(i, y) - pixels.data())] = 1;
        }
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            bool calm = true;
            for (int j = std::max(0, y - reach); j <= std::min(height - 1, y + reach); ++j)
                calm = calm && rows[static_cast<std::size_t>(&at(x, j) - pixels.data())] == 0;
            at(x, y).calm = calm;
        }
}

/// Every pixel of the colour camera, top row first. `reach`: pixels around one that have to be
/// free of edges for it to be calm.
inline std::vector<TruePixel> truePixels(const devices::sim::Snapshot& scene,
                                         const calib::SensorRig& rig,
                                         const calib::RigidTransform& sceneFromColor, int reach) {
    const calib::Intrinsics& picture = rig.color.intrinsics;
    const calib::RigidTransform sceneFromDepth = sceneFromColor * rig.colorFromDepth;
    std::vector<TruePixel> pixels;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const auto hit = hitAtPixel(scene, rig.color, sceneFromColor, {x, y});
            TruePixel pixel;
            if (hit)
                pixel = {hit->distance, isSeenBy(scene, rig.depth, sceneFromDepth, hit->point),
                         false};
            pixels.push_back(pixel);
        }
    markCalm(pixels, picture.width, picture.height, reach);
    return pixels;
}

} // namespace autostereo::oracle
