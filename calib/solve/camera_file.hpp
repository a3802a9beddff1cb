#pragma once

#include "calib/camera_model.hpp"
#include "calib/rigid_transform.hpp"

#include <optional>
#include <string>

namespace autostereo::calibrate {

/// What a calibration of another program holds.
struct CameraFile {
    std::optional<calib::CameraModel> first;  ///< the only one, or the left or depth camera of two
    std::optional<calib::CameraModel> second; ///< of a stereo file
    std::optional<calib::RigidTransform> secondFromFirst; ///< metres
};

/// Pixels of the camera's pictures, for files that do not say; 0x0: not known.
struct PictureSize {
    int width = 0, height = 0;
};

/// OpenCV's YAML, XML or JSON (camera_matrix, distortion_coefficients, image_width or their usual
/// spellings; M1 D1 M2 D2 R T of stereo calibrations; rotation and translation) or a ROS
/// camera_info file. `unitM`: metres of a translation's unit. Throws Refusal: `name: key: what is
/// wrong`.
[[nodiscard]] CameraFile readCameraFile(const std::string& text, const std::string& name,
                                        PictureSize size, double unitM);

} // namespace autostereo::calibrate
