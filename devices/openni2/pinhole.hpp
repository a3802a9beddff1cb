#pragma once

#include "calib/camera_model.hpp"

#include <cmath>

namespace autostereo::devices::openni2 {

/// All that OpenNI2 knows of a camera: its fields of view, radians; 0: not said.
[[nodiscard]] inline calib::CameraModel pinhole(int width, int height, double horizontalFov,
                                                double verticalFov) {
    constexpr double kUsualFov = 1.0; // across, most sensors' within 10 %
    const double across = horizontalFov > 0 ? horizontalFov : kUsualFov;
    const double fx = 0.5 * width / std::tan(0.5 * across);
    const double fy = verticalFov > 0 ? 0.5 * height / std::tan(0.5 * verticalFov) : fx;
    calib::CameraModel camera;
    camera.intrinsics = {width, height, fx, fy, 0.5 * (width - 1), 0.5 * (height - 1)};
    return camera;
}

} // namespace autostereo::devices::openni2
