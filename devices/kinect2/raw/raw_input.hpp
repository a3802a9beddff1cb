#pragma once

#include "devices/input.hpp"

#include <filesystem>
#include <optional>

namespace autostereo::devices::kinect2 {

/// Whether a file begins as a raw recording does.
[[nodiscard]] bool isRawRecording(const std::filesystem::path& path);

/// Opens what `RawRecorder` wrote: packets go the way of a running camera's, and frames come out
/// with the same bytes. `rig` replaces the unit's own. Throws DeviceError.
[[nodiscard]] Input openRawRecording(const std::filesystem::path& path,
                                     const std::optional<calib::SensorRig>& rig);

} // namespace autostereo::devices::kinect2
