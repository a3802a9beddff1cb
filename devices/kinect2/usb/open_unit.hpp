#pragma once

#include "devices/input.hpp"
#include "devices/uri.hpp"

#include <optional>

namespace autostereo::devices::kinect2 {

/// Opens `kinect2:[serial]`: depth and colour of a Kinect v2, the first one found where none is
/// named, with its factory's calibration unless `rig` is given. When it is lost the same unit is
/// looked for again. Throws DeviceError.
[[nodiscard]] Input openKinect2(const Uri& uri, const std::optional<calib::SensorRig>& rig);

} // namespace autostereo::devices::kinect2
