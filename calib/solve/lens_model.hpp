#pragma once

#include "calib/camera_model.hpp"

#include <array>
#include <cstddef>
#include <string_view>

namespace autostereo::calibrate {

/// Which terms of the distortion are free, in rising order; focal lengths and centre always are.
enum class LensModel { Plain, Two, Tangential, Five, Rational };

inline constexpr std::array kLensModels{LensModel::Plain, LensModel::Two, LensModel::Tangential,
                                        LensModel::Five, LensModel::Rational};

[[nodiscard]] constexpr std::string_view nameOf(LensModel model) {
    constexpr std::array<std::string_view, 5> kNames{
        "no distortion", "k1 k2", "k1 k2 p1 p2 (k3 = 0)", "k1 k2 p1 p2 k3", "k1...k6 p1 p2"};
    return kNames[static_cast<std::size_t>(model)];
}

/// fx fy cx cy, then k1 k2 p1 p2 k3 k4 k5 k6.
constexpr std::size_t kCameraParameters = 12;
constexpr std::size_t kFirstTerm = 4;

[[nodiscard]] constexpr std::size_t freeParameters(LensModel model) {
    constexpr std::array<std::size_t, 5> kFree{4, 6, 8, 9, 12};
    return kFree[static_cast<std::size_t>(model)];
}

using CameraParameters = std::array<double, kCameraParameters>;

[[nodiscard]] inline CameraParameters parametersOf(const calib::CameraModel& camera) {
    const calib::Intrinsics& i = camera.intrinsics;
    const calib::Distortion& k = camera.distortion;
    return {i.fx, i.fy, i.cx, i.cy, k.k1, k.k2, k.p1, k.p2, k.k3, k.k4, k.k5, k.k6};
}

inline void setParameters(calib::CameraModel& camera, const CameraParameters& p) {
    calib::Intrinsics& i = camera.intrinsics;
    i.fx = p[0], i.fy = p[1], i.cx = p[2], i.cy = p[3];
    const double radius = camera.distortion.metricRadius;
    camera.distortion = {p[4], p[5], p[6], p[7], p[8], p[9], p[10], p[11], radius};
}

} // namespace autostereo::calibrate
