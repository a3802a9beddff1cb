#pragma once

#include "devices/input.hpp"

#include <filesystem>
#include <optional>

namespace autostereo::devices::openni2 {

/// Opens an OpenNI2 recording: depth (with infrared as amplitude) and colour, each read by a
/// process of its own, `autostereo-oni-reader`, in which the library may crash or hang without
/// harm. Every frame comes once. The recorder that writes such files damages depth without a word
/// when a frame has more than 32768 different values, as steps of 0.1 mm have: such files are
/// opened with a warning. Without `rig` as `openOpenNi`. Throws DeviceError.
[[nodiscard]] Input openOniFile(const std::filesystem::path& path,
                                const std::optional<calib::SensorRig>& rig);

} // namespace autostereo::devices::openni2
