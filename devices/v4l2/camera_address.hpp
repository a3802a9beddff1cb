#pragma once

#include "devices/uri.hpp"
#include "devices/v4l2/camera_controls.hpp"
#include "devices/v4l2/camera_format.hpp"
#include "devices/v4l2/find_cameras.hpp"

#include <optional>

namespace autostereo::devices::v4l2 {

/// What a `v4l2:` address says:
///   v4l2:                      the first camera there is
///   v4l2:/dev/video0           a node, or a link to one
///   v4l2:usb-0000:00:14.0-2    where it is plugged in, as `v4l2-ctl --list-devices` prints it
///   v4l2:serial=1234           the USB serial number
/// and behind a question mark: as=color|depth, size=1280x720, fps=30, format=MJPG, unit_mm=1
/// (depth), exposure_ms=8, power_line=50|60|auto|off, white_balance=4600 (kelvin),
/// zero_copy=auto|off (whether pictures may come to the GPU without a copy).
struct CameraAddress {
    std::string text;
    CameraName name;
    std::optional<Role> role; ///< none: depth where the camera offers Z16, else colour
    ModeRequest mode;
    double depthUnitM = 0.001;
    ControlParams controls;
    bool zeroCopy = true;
};

/// Throws AddressError for words that mean nothing.
[[nodiscard]] CameraAddress cameraAddress(const Uri& uri);

} // namespace autostereo::devices::v4l2
