#include "daemon/commands/commands.hpp"
#include "daemon/wiring.hpp"
#include "devices/display/connectors.hpp"
#include "devices/display/drm_reader.hpp"
#include "devices/display/looking_glass_volumes.hpp"
#include "devices/kinect2/usb/find_units.hpp"
#include "devices/sysfs.hpp"
#include "devices/v4l2/camera_report.hpp"
#include "gpu/window_panel.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <iostream>

namespace autostereo::daemon {

namespace {

using Json = nlohmann::ordered_json;

Json monitorsJson() {
    Json list = Json::array();
    for (const gpu::MonitorInfo& monitor : gpu::listMonitors())
        list.push_back({{"name", monitor.name},
                        {"width", monitor.width},
                        {"height", monitor.height},
                        {"refresh_hz", monitor.refreshHz}});
    return list;
}

Json problemsJson(const devices::LinkState& link) {
    Json list = Json::array();
    for (const devices::LinkProblem& problem : devices::linkProblems(link)) {
        const bool refuse = problem.severity == devices::LinkProblem::Severity::Refuse;
        list.push_back({{"severity", refuse ? "refuse" : "warn"}, {"text", problem.text}});
    }
    return list;
}

Json connectorJson(const devices::Connector& connector, const devices::DrmReading& drm) {
    Json json{{"card", connector.card},
              {"connector", connector.name},
              {"enabled", connector.enabled},
              {"edid", nullptr}};
    if (connector.edid)
        json["edid"] = {{"manufacturer", connector.edid->manufacturer},
                        {"name", connector.edid->monitorName},
                        {"serial", connector.edid->serialText},
                        {"width", connector.edid->nativeWidth},
                        {"height", connector.edid->nativeHeight},
                        {"width_mm", connector.edid->widthM * 1e3},
                        {"height_mm", connector.edid->heightM * 1e3},
                        {"faults", connector.edid->faults}};
    else
        json["edid_problem"] = connector.edidProblem;
    json["modes"] = Json::array();
    for (const auto& mode : connector.modes)
        json["modes"].push_back(std::to_string(mode.width) + "x" + std::to_string(mode.height));
    json["link"] = problemsJson(devices::linkOf(connector, drm.pipes));
    return json;
}

Json volumesJson(const std::filesystem::path& root) {
    const char* home = std::getenv("HOME");
    Json list = Json::array();
    for (const auto& volume : devices::findLookingGlassVolumes(root, home != nullptr ? home : "")) {
        list.push_back({{"label", volume.label}, {"device", volume.device}});
        list.back()["calibration"] =
            volume.calibration ? Json(volume.calibration->string()) : Json();
    }
    return list;
}

Json camerasJson(const std::filesystem::path& root) {
    Json list = Json::array();
    for (const auto& camera : devices::v4l2::reportCameras(root)) {
        const devices::v4l2::CameraNode& node = camera.node;
        Json modes = Json::array();
        for (const devices::v4l2::Mode& mode : camera.modes)
            modes.push_back(text(mode));
        list.push_back({{"node", node.path.string()},
                        {"name", node.name},
                        {"serial", node.serial},
                        {"bus", node.bus},
                        {"usb_mbps", node.usbMbps == 0 ? Json() : Json(node.usbMbps)},
                        {"modes", modes},
                        {"problems", camera.problems}});
    }
    return list;
}

Json kinectsJson(const std::filesystem::path& root) {
    Json list = Json::array();
    for (const auto& unit : devices::kinect2::findUnits(root))
        list.push_back({{"serial", unit.serial},
                        {"node", unit.node.string()},
                        {"port", unit.port},
                        {"usb_mbps", unit.usbMbps},
                        {"problems", devices::kinect2::problemsWith(unit, root)}});
    return list;
}

Json findAll(const std::filesystem::path& root) {
    Json found{{"monitors", monitorsJson()}, {"connectors", Json::array()}};
    const devices::DrmReading drm = devices::readDrm(root / "dev/dri");
    for (const devices::Connector& connector : devices::connectedMonitors(root))
        found["connectors"].push_back(connectorJson(connector, drm));
    found["unread_cards"] = drm.notes;
    found["looking_glass"] = volumesJson(root);
    found["cameras"] = camerasJson(root);
    found["kinect2"] = kinectsJson(root);
    const auto usbMemory = devices::usbMemoryMib(root);
    found["usbfs_memory_mb"] = usbMemory ? Json(*usbMemory) : Json();
    found["displays"] = Json::array();
    for (const std::string& name : config::displayNames())
        found["displays"].push_back({{"name", name}, {"model", config::loadDisplay(name).model}});
    found["inputs"] = {"sim:room", "sim:person", "sim:calibration-board",
                       "v4l2:",    "kinect2:",   "openni2:"};
    return found;
}

std::string text(const Json& value) { return value.get<std::string>(); }

void printConnectors(const Json& found) {
    std::cout << "connectors:" << (found["connectors"].empty() ? " none\n" : "\n");
    for (const Json& one : found["connectors"]) {
        std::cout << "  " << text(one["card"]) << " " << text(one["connector"]) << ": ";
        if (one["edid"].is_null())
            std::cout << text(one["edid_problem"]) << '\n';
        else
            std::cout << text(one["edid"]["manufacturer"]) << " '" << text(one["edid"]["name"])
                      << "' " << one["edid"]["width"] << "x" << one["edid"]["height"] << '\n';
        for (const Json& problem : one["link"])
            std::cout << "    " << text(problem["severity"]) << ": " << text(problem["text"])
                      << '\n';
    }
    for (const Json& note : found["unread_cards"])
        std::cout << "  unknown: " << text(note) << '\n';
}

void printVolumes(const Json& volumes) {
    std::cout << "looking glass volumes:" << (volumes.empty() ? " none\n" : "\n");
    for (const Json& one : volumes)
        std::cout << "  " << text(one["label"]) << ": "
                  << (one["calibration"].is_null() ? text(one["device"]) + " is not mounted"
                                                   : text(one["calibration"]))
                  << '\n';
}

void printCameras(const Json& found) {
    const bool none = found["cameras"].empty() && found["kinect2"].empty();
    std::cout << "cameras:" << (none ? " none\n" : "\n");
    for (const Json& one : found["cameras"]) {
        std::cout << "  " << text(one["node"]) << ": " << text(one["name"]) << ", "
                  << text(one["bus"]);
        if (one["serial"] != "") std::cout << ", serial " << text(one["serial"]);
        if (!one["usb_mbps"].is_null()) std::cout << ", " << one["usb_mbps"] << " Mb/s";
        std::cout << ", " << one["modes"].size() << " modes\n";
        for (const Json& mode : one["modes"])
            std::cout << "    " << text(mode) << '\n';
        for (const Json& problem : one["problems"])
            std::cout << "    problem: " << text(problem) << '\n';
    }
    for (const Json& one : found["kinect2"]) {
        std::cout << "  kinect2:" << text(one["serial"]) << ": Kinect v2, port "
                  << text(one["port"]) << ", " << one["usb_mbps"] << " Mb/s\n";
        for (const Json& problem : one["problems"])
            std::cout << "    problem: " << text(problem) << '\n';
    }
    if (!found["usbfs_memory_mb"].is_null())
        std::cout << "USB memory: " << found["usbfs_memory_mb"] << " MiB for all programs\n";
}

void print(const Json& found) {
    std::cout << "monitors:" << (found["monitors"].empty() ? " none\n" : "\n");
    for (const Json& monitor : found["monitors"])
        std::cout << "  " << text(monitor["name"]) << " " << monitor["width"] << "x"
                  << monitor["height"] << " " << monitor["refresh_hz"] << " Hz\n";
    printConnectors(found);
    printVolumes(found["looking_glass"]);
    printCameras(found);
    std::cout << "display profiles:\n";
    for (const Json& display : found["displays"])
        std::cout << "  " << text(display["name"]) << ": " << text(display["model"]) << '\n';
    std::cout << "inputs:\n";
    for (const Json& input : found["inputs"])
        std::cout << "  " << text(input) << '\n';
}

} // namespace

int listDevices(const DevicesOptions& options) {
    const Json found = findAll(options.root);
    if (options.json) // labels come from volumes: any bytes
        std::cout << found.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
    else
        print(found);
    return EXIT_SUCCESS;
}

} // namespace autostereo::daemon
