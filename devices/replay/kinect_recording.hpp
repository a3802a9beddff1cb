#pragma once

#include "devices/input.hpp"

#include <filesystem>
#include <optional>

namespace autostereo::devices {

/// Opens a recording in the Azure Kinect convention (Matroska): tracks COLOR (MJPG, NV12, YUY2 or
/// BGRA), DEPTH and IR (b16g), calibration.json attached. The IR picture of a depth frame's time
/// becomes its amplitude. Either camera may be missing. Times are the device's own, K4A's start
/// offset included. `rig` replaces the attached calibration. Throws DeviceError.
[[nodiscard]] Input openKinectRecording(const std::filesystem::path& path,
                                        const std::optional<calib::SensorRig>& rig);

} // namespace autostereo::devices
