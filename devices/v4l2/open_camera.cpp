#include "devices/v4l2/open_camera.hpp"

#include "devices/nominal_camera.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace autostereo::devices::v4l2 {

namespace {

std::string listed(const std::vector<CameraNode>& nodes) {
    std::string all;
    for (const CameraNode& node : nodes)
        all += (all.empty() ? "" : ", ") + node.path.string() + " '" + node.name + "'";
    return all.empty() ? "there is none" : "there are " + all;
}

std::string listed(const std::vector<Mode>& modes) {
    constexpr std::size_t kMost = 12;
    std::string all;
    for (std::size_t i = 0; i < std::min(modes.size(), kMost); ++i)
        all += (i == 0 ? "" : ", ") + text(modes[i]);
    return modes.size() > kMost ? all + ", ..." : all;
}

/// The node that is meant; the first capture node of several.
VideoNode openNode(const CameraAddress& address) {
    const std::vector<CameraNode> nodes = findCameras();
    std::optional<std::string> problem;
    for (const std::filesystem::path& path : candidates(address.name, nodes)) {
        try {
            VideoNode node(path);
            const bool meant =
                address.name.by != CameraName::By::Bus || node.bus() == address.name.text;
            if (meant && node.captures()) return node;
            if (meant && !problem)
                problem = "v4l2: cannot open " + node.path() +
                          ": it is no camera (it captures no frames)";
        } catch (const DeviceError& error) {
            if (address.name.by == CameraName::By::Path) throw;
            if (!problem) problem = error.what();
        }
    }
    if (problem) throw DeviceError(*problem);
    throw DeviceError(
        "v4l2: cannot open " + address.text + ": no such camera (" + listed(nodes) + ")", true);
}

/// The mode to run it in, and as what.
Mode modeOf(const VideoNode& node, const CameraAddress& address, ModeRequest& request) {
    const std::vector<Mode> offered = node.modes(address.mode);
    for (const Role role : {Role::Depth, Role::Color}) {
        if (address.role && *address.role != role) continue;
        request.role = role;
        // Y16 may be infrared: only who asks for depth gets it as depth.
        std::vector<Mode> fitting = offered;
        if (!address.role)
            std::erase_if(fitting, [](const Mode& mode) { return text(mode.code) == "Y16"; });
        if (const auto mode = chooseMode(fitting, request)) return *mode;
    }
    throw DeviceError(
        "v4l2: cannot use " + node.path() + " as " + address.text + ": none of its modes fits (" +
        (offered.empty() ? "it offers none that can be shown" : listed(offered)) + ")");
}

/// By serial number, where no other camera has the same; else by where it is plugged in.
CameraName lastingName(const CameraAddress& address, const VideoNode& node) {
    std::error_code error;
    const std::filesystem::path real = std::filesystem::canonical(node.path(), error);
    const std::vector<CameraNode> nodes = findCameras();
    const auto self = std::ranges::find(nodes, real, &CameraNode::path);
    if (self == nodes.end()) return address.name;
    const auto twins = std::ranges::count_if(nodes, [&](const CameraNode& one) {
        return one.serial == self->serial && one.index == self->index;
    });
    if (!self->serial.empty() && twins == 1)
        return {CameraName::By::Serial, self->serial, self->index};
    return {CameraName::By::Bus, node.bus(), self->index};
}

} // namespace

OpenCamera openCamera(const CameraAddress& address, std::shared_ptr<Continuity> continuity) {
    VideoNode node = openNode(address);
    ModeRequest request = address.mode;
    const Mode mode = modeOf(node, address, request);
    OpenCamera camera;
    camera.role = request.role;
    camera.name = lastingName(address, node);
    CaptureStream stream(std::move(node), mode);
    camera.warnings = setControls(stream.node(), address.controls);
    camera.description = stream.node().card() + ", " + text(stream.agreed().mode);
    camera.source = std::make_unique<V4l2Source>(std::move(stream), address.depthUnitM,
                                                 address.controls, std::move(continuity));
    return camera;
}

Input openV4l2(const Uri& uri, const std::optional<calib::SensorRig>& rig) {
    CameraAddress address = cameraAddress(uri);
    const auto continuity = std::make_shared<Continuity>();
    if (address.zeroCopy) continuity->sharing = std::make_shared<PixelSharing>();
    OpenCamera camera = openCamera(address, continuity);
    const Mode& mode = camera.source->stream().agreed().mode;
    const bool depth = camera.role == Role::Depth;

    Input input;
    input.uri = uri.text;
    input.description = camera.description + (depth ? " depth" : "");
    input.nominalPeriod = mode.period;
    input.warnings = camera.warnings;
    input.rig = rig;
    if (rig) {
        calib::CameraModel& model = depth ? input.rig->depth : input.rig->color;
        const calib::Intrinsics& known = model.intrinsics;
        if (known.width * mode.height != known.height * mode.width)
            input.warnings.push_back(uri.text + ": " + text(mode) +
                                     " has another shape than the calibration's picture");
        model = model.resized(mode.width, mode.height);
    } else {
        const calib::CameraModel nominal = nominalCamera(mode.width, mode.height);
        input.rig = calib::SensorRig{nominal, nominal, {}, "nominal"};
        input.warnings.push_back(uri.text + ": no calibration: a 63 degree field of view is "
                                            "assumed (give --rig)");
    }
    // The camera comes back as what it is now, though its number may be another.
    address.name = camera.name;
    address.role = camera.role;
    address.mode.code = mode.code;
    address.mode.width = mode.width;
    address.mode.height = mode.height;
    const auto reopen = [address, continuity]() -> std::unique_ptr<Source> {
        OpenCamera again = openCamera(address, continuity);
        for (const std::string& warning : again.warnings)
            spdlog::debug("{}", warning);
        return std::move(again.source);
    };
    (depth ? input.depth : input.color) = std::move(camera.source);
    (depth ? input.reopen.depth : input.reopen.color) = reopen;
    (depth ? input.depthIsLive : input.colorIsLive) = true;
    return input;
}

} // namespace autostereo::devices::v4l2
