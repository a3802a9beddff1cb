#include "daemon/commands.hpp"
#include "daemon/wiring.hpp"
#include "gpu/window_panel.hpp"

#include <nlohmann/json.hpp>

#include <iostream>

namespace autostereo::daemon {

int listDevices(const DevicesOptions& options) {
    nlohmann::ordered_json found{{"monitors", nlohmann::ordered_json::array()},
                                 {"displays", nlohmann::ordered_json::array()},
                                 {"inputs", {"sim:room", "sim:person", "sim:calibration-board"}}};
    for (const gpu::MonitorInfo& monitor : gpu::listMonitors())
        found["monitors"].push_back({{"name", monitor.name},
                                     {"width", monitor.width},
                                     {"height", monitor.height},
                                     {"refresh_hz", monitor.refreshHz}});
    for (const std::string& name : config::displayNames())
        found["displays"].push_back({{"name", name}, {"model", config::loadDisplay(name).model}});
    if (options.json) {
        std::cout << found.dump(2) << '\n';
        return EXIT_SUCCESS;
    }
    std::cout << "monitors:" << (found["monitors"].empty() ? " none\n" : "\n");
    for (const auto& monitor : found["monitors"])
        std::cout << "  " << monitor["name"].get<std::string>() << " " << monitor["width"] << "x"
                  << monitor["height"] << " " << monitor["refresh_hz"] << " Hz\n";
    std::cout << "display profiles:\n";
    for (const auto& display : found["displays"])
        std::cout << "  " << display["name"].get<std::string>() << ": "
                  << display["model"].get<std::string>() << '\n';
    std::cout << "inputs:\n";
    for (const auto& input : found["inputs"])
        std::cout << "  " << input.get<std::string>() << '\n';
    return EXIT_SUCCESS;
}

} // namespace autostereo::daemon
