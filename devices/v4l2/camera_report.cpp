#include "devices/v4l2/camera_report.hpp"

#include "devices/input.hpp"
#include "devices/v4l2/node_holders.hpp"
#include "devices/v4l2/video_node.hpp"

#include <algorithm>

namespace autostereo::devices::v4l2 {

namespace {

constexpr int kHighSpeedMbps = 480;

/// Of each format and size the fastest.
std::vector<Mode> fastest(const std::vector<Mode>& modes) {
    std::vector<Mode> kept;
    for (const Mode& mode : modes) {
        const auto same = std::ranges::find_if(kept, [&](const Mode& one) {
            return one.code == mode.code && one.width == mode.width && one.height == mode.height;
        });
        if (same == kept.end())
            kept.push_back(mode);
        else
            same->period = std::min(same->period, mode.period);
    }
    return kept;
}

} // namespace

std::vector<CameraReport> reportCameras(const std::filesystem::path& root) {
    std::vector<CameraReport> reports;
    for (const CameraNode& found : findCameras(root)) {
        CameraReport report{found, {}, {}};
        try {
            const VideoNode node(found.path);
            if (!node.captures()) continue;
            report.modes = fastest(node.modes({}));
            if (report.node.bus.empty()) report.node.bus = node.bus();
            if (report.modes.empty())
                report.problems.emplace_back("it has no format that can be shown");
        } catch (const DeviceError& error) {
            report.problems.emplace_back(error.what());
        }
        if (found.usb3 && found.usbMbps > 0 && found.usbMbps <= kHighSpeedMbps)
            report.problems.emplace_back("it is made for USB 3 or 2.1 and runs at " +
                                         std::to_string(found.usbMbps) +
                                         " Mb/s: try a blue port and another cable");
        const std::string holders = holdersOf(found.path, root / "proc");
        if (!holders.empty()) report.problems.emplace_back("in use by " + holders);
        reports.push_back(std::move(report));
    }
    return reports;
}

} // namespace autostereo::devices::v4l2
