#pragma once

#include "calib/camera_model.hpp"
#include "calib/rigid_transform.hpp"

#include <optional>
#include <string>

namespace autostereo::calibrate {

/// OpenCV's YAML as its own samples write stereo calibrations: depth camera M1 D1 and size1, colour
/// camera M2 D2 and size2, R and T (metres) of p_color = R p_depth + T. D is k1 k2 p1 p2 k3 k4 k5
/// k6.
[[nodiscard]] std::string openCvYaml(const std::optional<calib::CameraModel>& depth,
                                     const std::optional<calib::CameraModel>& color,
                                     const std::optional<calib::RigidTransform>& colorFromDepth);

} // namespace autostereo::calibrate
