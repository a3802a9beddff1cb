#pragma once

#include "devices/kinect2/calibration.hpp"

#include <string>

namespace autostereo::devices::kinect2 {

/// A unit's calibration as libfreenect2 names it.
struct Parameters {
    DepthCamera depth;      ///< getIrCameraParams
    ColorCalibration color; ///< getColorCameraParams, without check points
};

/// {"ir": {"fx": ..., "fy", "cx", "cy", "k1", "k2", "k3", "p1", "p2"}, "color": {"fx", "cx", "cy",
/// "shift_d", "shift_m", "mx_x3y0" ... "my_x0y0"}}, numbers as the library returns them: pixels
/// counted from the corner of the first one, shifts in millimetres. Other keys are ignored. `name`:
/// of the file, for complaints. Throws DeviceError.
[[nodiscard]] Parameters readParameters(const std::string& text, const std::string& name);

} // namespace autostereo::devices::kinect2
