#pragma once

#include "calib/sensor_rig.hpp"
#include "devices/replay/image.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace autostereo::devices {

/// What a camera.json says; either camera may be absent, not both.
struct CameraFile {
    std::optional<calib::CameraModel> depth;
    std::optional<calib::CameraModel> color;
    calib::RigidTransform colorFromDepth;
    std::optional<double> depthUnitM; ///< metres per count
    std::string name;                 ///< the file, for messages and provenance

    /// Both cameras; an absent one is taken to be the other one (registered pictures).
    [[nodiscard]] calib::SensorRig rig() const;
};

/// Reads `camera.json`: blocks `depth` and `color` with width, height, fx, fy, cx, cy and optional
/// distortion_k1k2p1p2k3k4k5k6, metric_radius, depth_scale_m; optional `depth_to_color` with
/// R_rowmajor and t_m. Or Open3D's file: width, height, intrinsic_matrix (column by column), one
/// camera for both pictures. Throws DeviceError as `file: key: what is wrong (allowed ...)`.
[[nodiscard]] CameraFile readCameraFile(const std::filesystem::path& path);
/// The same from memory, `name` being the file.
[[nodiscard]] CameraFile readCameraFile(std::span<const std::byte> json, const std::string& name);
/// Both cameras as a camera.json, without loss.
[[nodiscard]] std::string cameraFile(const calib::SensorRig& rig);

/// The factory calibration of an Azure Kinect (JSON) for the modes with these picture sizes, which
/// name a depth mode and a colour resolution uniquely. A 0x0 size: that stream is not there, its
/// camera is taken to be the other one. Throws DeviceError as above, `name` being the file.
[[nodiscard]] calib::SensorRig readKinectCalibration(std::span<const std::byte> json,
                                                     const std::string& name, PictureSize depth,
                                                     PictureSize color);

} // namespace autostereo::devices
