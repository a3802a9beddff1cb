#pragma once

#include "devices/input.hpp"

#include <filesystem>
#include <optional>

namespace autostereo::devices {

/// What our own recordings say beyond the convention: metres per count where it is not 0.001, and
/// the attachment (camera.json) that has both cameras as they were used.
inline constexpr const char* kDepthUnitTag = "AUTOSTEREO_DEPTH_UNIT_M";
inline constexpr const char* kCameraFileTag = "AUTOSTEREO_CAMERA_FILE";

/// Opens a recording in the Azure Kinect convention (Matroska): tracks COLOR (MJPG, NV12, YUY2 or
/// BGRA), DEPTH and IR (b16g), calibration.json attached. The IR picture of a depth frame's time
/// becomes its amplitude. Either camera may be missing. Times are the device's own, K4A's start
/// offset included. `rig` replaces the attached calibration. Throws DeviceError.
[[nodiscard]] Input openKinectRecording(const std::filesystem::path& path,
                                        const std::optional<calib::SensorRig>& rig);

} // namespace autostereo::devices
