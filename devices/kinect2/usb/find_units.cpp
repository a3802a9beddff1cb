#include "devices/kinect2/usb/find_units.hpp"

#include "devices/sysfs.hpp"

#include <algorithm>
#include <cstdio>

#include <unistd.h>

namespace autostereo::devices::kinect2 {

namespace {

namespace fs = std::filesystem;

bool isKinect2(const fs::path& device) {
    if (sysfsLine(device / "idVendor") != "045e") return false;
    const std::string product = sysfsLine(device / "idProduct");
    return product == "02d8" || product == "02c4"; // 02c4: the preview hardware
}

fs::path nodeOf(const fs::path& device, const fs::path& root) {
    char name[16];
    std::snprintf(name, sizeof name, "%03d/%03d",
                  leadingNumber(sysfsLine(device / "busnum")) % 1000,
                  leadingNumber(sysfsLine(device / "devnum")) % 1000);
    return root / "dev/bus/usb" / name;
}

} // namespace

std::vector<UnitNode> findUnits(const fs::path& root) {
    std::vector<UnitNode> units;
    std::error_code error;
    fs::directory_iterator entry(root / "sys/bus/usb/devices", error);
    for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
        const fs::path& device = entry->path();
        if (isKinect2(device))
            units.push_back({nodeOf(device, root), sysfsLine(device / "serial"),
                             device.filename().string(),
                             leadingNumber(sysfsLine(device / "speed"))});
    }
    std::ranges::sort(units, {}, &UnitNode::port);
    return units;
}

std::vector<std::string> problemsWith(const UnitNode& unit, const fs::path& root) {
    constexpr int kSuperSpeedMbps = 5000;
    std::vector<std::string> problems;
    if (unit.usbMbps < kSuperSpeedMbps)
        problems.push_back("it needs USB 3 and runs at " + std::to_string(unit.usbMbps) +
                           " Mb/s: try a blue port and another cable");
    if (access(unit.node.c_str(), R_OK | W_OK) != 0)
        problems.push_back("no permission to use " + unit.node.string() + ": " + kHowToPermit);
    const int memory = usbMemoryMib(root).value_or(0);
    if (memory > 0 && memory < kUsbMemoryMib)
        problems.push_back("programs may take " + std::to_string(memory) +
                           " MiB for USB transfers, it needs " + std::to_string(kUsbMemoryMib) +
                           ": add usbcore.usbfs_memory_mb=64 to the kernel's command line");
    return problems;
}

} // namespace autostereo::devices::kinect2
