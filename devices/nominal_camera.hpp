#pragma once

#include "calib/camera_model.hpp"

namespace autostereo::devices {

/// What a camera without calibration is taken for: no distortion, the axis in the middle, 63
/// degrees from left to right, what the RGB-D cameras of the PrimeSense family see.
[[nodiscard]] calib::CameraModel nominalCamera(int width, int height);

} // namespace autostereo::devices
