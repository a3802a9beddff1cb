#pragma once

#include "devices/input.hpp"
#include "devices/uri.hpp"

#include <optional>

namespace autostereo::devices::openni2 {

/// Opens `openni2:[URI][?registered=on|off&depth=1mm|0.1mm]`: depth and colour of a device, the
/// first one found where none is named. Without `rig` the cameras are pinholes with the fields of
/// view that the device states, in one place; the library itself knows no more. Throws DeviceError.
[[nodiscard]] Input openOpenNi(const Uri& uri, const std::optional<calib::SensorRig>& rig);

} // namespace autostereo::devices::openni2
