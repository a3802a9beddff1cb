#pragma once

#include "tests/device/uvc/uvc_camera.hpp"

namespace autostereo::test {

/// Most bytes of one bulk payload: uvcvideo's transfers are of 32 packets.
inline constexpr unsigned kUvcBulkPayload = 32 * 512;
/// Most bytes of one isochronous interval: three packets of 1024.
inline constexpr unsigned kUvcIntervalBytes = 3 * 1024;

/// Entities of the camera's control interface.
inline constexpr unsigned kUvcTerminal = 1, kUvcProcessing = 2;

/// Everything that a UVC 1.1 camera with these formats says about itself.
[[nodiscard]] usbip::Descriptors uvcDescriptors(const UvcParams& params);

} // namespace autostereo::test
