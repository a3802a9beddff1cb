#pragma once

#include "devices/input.hpp"

namespace autostereo::devices {

/// One input's depth with another's colour. Where `rig` says nothing, each camera keeps its own
/// numbers and they are taken to stand in one place, with a warning. Throws DeviceError where the
/// one has no depth or the other no colour.
[[nodiscard]] Input joined(Input depth, Input color, const std::optional<calib::SensorRig>& rig);

} // namespace autostereo::devices
