#include "devices/v4l2/find_cameras.hpp"

#include "devices/sysfs.hpp"

#include <algorithm>
#include <charconv>

namespace autostereo::devices::v4l2 {

namespace {

namespace fs = std::filesystem;

/// Of /dev/video12: 12. -1: no node of video.
int nodeNumber(const fs::path& path) {
    const std::string name = path.filename().string();
    int value = -1;
    if (!name.starts_with("video")) return value;
    const auto [end, error] = std::from_chars(name.data() + 5, name.data() + name.size(), value);
    return error == std::errc{} && end == name.data() + name.size() ? value : -1;
}

/// As uvcvideo makes it of the host controller and the ports on the way: usb-CONTROLLER-1.2.
std::string busName(const fs::path& usbDevice) {
    const std::string ports = usbDevice.filename().string(); // 3-1.2
    for (fs::path up = usbDevice; up.has_relative_path(); up = up.parent_path())
        if (up.filename().string().starts_with("usb"))
            return "usb-" + up.parent_path().filename().string() + "-" +
                   ports.substr(ports.find('-') + 1);
    return {};
}

void readUsb(const fs::path& interface, CameraNode& node) {
    const fs::path usbDevice = interface.parent_path();
    std::error_code error;
    if (!fs::exists(usbDevice / "idVendor", error)) return;
    node.serial = sysfsLine(usbDevice / "serial");
    node.usbMbps = leadingNumber(sysfsLine(usbDevice / "speed"));
    const std::string version = sysfsLine(usbDevice / "version"); // " 2.10": able to do more
    node.usb3 =
        version.find("3.") != std::string::npos || version.find("2.10") != std::string::npos;
    node.bus = busName(usbDevice);
}

} // namespace

std::vector<CameraNode> findCameras(const fs::path& root) {
    std::vector<CameraNode> nodes;
    std::error_code error;
    fs::directory_iterator entry(root / "sys/class/video4linux", error);
    for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
        const fs::path& about = entry->path();
        if (nodeNumber(about) < 0) continue;
        CameraNode node;
        node.path = root / "dev" / about.filename();
        node.name = sysfsLine(about / "name");
        node.index = leadingNumber(sysfsLine(about / "index"));
        std::error_code none;
        const fs::path device = fs::canonical(about / "device", none);
        if (!none) readUsb(device, node);
        nodes.push_back(std::move(node));
    }
    std::ranges::sort(nodes, {}, [](const CameraNode& node) { return nodeNumber(node.path); });
    return nodes;
}

std::vector<fs::path> candidates(const CameraName& name, const std::vector<CameraNode>& nodes) {
    if (name.by == CameraName::By::Path) return {name.text};
    std::vector<fs::path> paths;
    for (const CameraNode& node : nodes) {
        // A bus that sysfs does not tell is asked of the node itself, once it is open.
        if ((name.by == CameraName::By::Serial && node.serial != name.text) ||
            (name.by == CameraName::By::Bus && !node.bus.empty() && node.bus != name.text) ||
            (name.index && *name.index != node.index))
            continue;
        paths.push_back(node.path);
    }
    return paths;
}

} // namespace autostereo::devices::v4l2
