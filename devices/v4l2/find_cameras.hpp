#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace autostereo::devices::v4l2 {

/// What sysfs says of one V4L2 node, without opening it.
struct CameraNode {
    std::filesystem::path path; ///< /dev/videoN
    std::string name;           ///< the model's
    std::string serial;         ///< of the USB device; empty: it has none
    std::string bus;            ///< as V4L2 names it ("usb-0000:00:14.0-2"), as far as sysfs tells
    int usbMbps = 0;            ///< negotiated speed, 0: not USB
    bool usb3 = false;          ///< made for USB 3
    int index = 0;              ///< among the nodes of one device; cameras have further ones
};

/// All V4L2 nodes, in the order of their numbers. `root` is where /sys and /dev lie; what cannot be
/// read is left out. Reentrant.
[[nodiscard]] std::vector<CameraNode> findCameras(const std::filesystem::path& root = "/");

/// How a camera is named, so that it is found again wherever it comes back.
struct CameraName {
    enum class By : std::uint8_t { First, Path, Bus, Serial };
    By by = By::First;
    std::string text;
    std::optional<int> index{}; ///< of several nodes of one device, this one
};

/// The nodes that may be meant, best first; for a path that path alone.
[[nodiscard]] std::vector<std::filesystem::path> candidates(const CameraName& name,
                                                            const std::vector<CameraNode>& nodes);

} // namespace autostereo::devices::v4l2
