#pragma once

#include "devices/input.hpp"
#include "devices/uri.hpp"
#include "devices/v4l2/camera_address.hpp"
#include "devices/v4l2/v4l2_source.hpp"

#include <memory>

namespace autostereo::devices::v4l2 {

/// A camera that was found, running.
struct OpenCamera {
    std::unique_ptr<V4l2Source> source;
    Role role = Role::Color;
    CameraName name;                   ///< finds it again, wherever it comes back
    std::string description;           ///< "Emulated camera, MJPG 1920x1080 30 fps"
    std::vector<std::string> warnings; ///< controls that it refused
};

/// Throws DeviceError: no such camera (with those there are), busy, no mode that fits (with those
/// there are), no permission.
[[nodiscard]] OpenCamera openCamera(const CameraAddress& address,
                                    std::shared_ptr<Continuity> continuity);

/// A `v4l2:` address as an input of one stream, which is opened again when it was lost.
[[nodiscard]] Input openV4l2(const Uri& uri, const std::optional<calib::SensorRig>& rig);

} // namespace autostereo::devices::v4l2
