#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace autostereo::devices::kinect2 {

/// What sysfs says of one camera on USB, without opening it.
struct UnitNode {
    std::filesystem::path node; ///< /dev/bus/usb/BBB/DDD
    std::string serial;         ///< empty: it says none
    std::string port;           ///< "2-1.3": bus and the ports on the way
    int usbMbps = 0;            ///< negotiated speed
};

/// All of them, in the order of their ports. `root` is where /sys and /dev lie. Reentrant.
[[nodiscard]] std::vector<UnitNode> findUnits(const std::filesystem::path& root = "/");

/// What keeps it from working, in sentences with what to do: the link's speed, permissions, memory.
[[nodiscard]] std::vector<std::string> problemsWith(const UnitNode& unit,
                                                    const std::filesystem::path& root = "/");

/// Memory that its transfers take, MiB.
inline constexpr int kUsbMemoryMib = 14;

/// How whoever sits at the machine lets programs at the camera.
inline constexpr const char* kHowToPermit =
    "copy systemd/70-autostereo.rules to /etc/udev/rules.d, then udevadm control --reload && "
    "udevadm trigger";

} // namespace autostereo::devices::kinect2
