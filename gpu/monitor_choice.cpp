#include "gpu/monitor_choice.hpp"

#include "gpu/gl/error.hpp"

#include <algorithm>
#include <charconv>

namespace autostereo::gpu {

namespace {

/// A name taken apart: "HDMI-A-1" is HDMI-A, 1; "eDP" has no number.
struct PortName {
    std::string_view type;
    std::optional<int> number;
};

PortName portOf(std::string_view name) {
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    std::size_t digits = name.size();
    while (digits > 0 && isDigit(name[digits - 1]))
        --digits;
    PortName port{name.substr(0, digits), std::nullopt};
    int number = 0;
    if (std::from_chars(name.data() + digits, name.data() + name.size(), number).ec == std::errc{})
        port.number = number;
    if (port.type.ends_with('-')) port.type.remove_suffix(1);
    return port;
}

/// The window systems' several words for a kernel's type of connector.
bool isType(std::string_view word, std::string_view type) {
    if (word == type) return true;
    if (type == "HDMI-A") return word == "HDMI";
    if (type == "DP") return word == "DisplayPort";
    if (type.starts_with("DVI-")) return word == "DVI";
    return false;
}

bool countsFromZero(std::span<const std::string> names) {
    return std::ranges::any_of(names, [](const std::string& name) {
        const PortName port = portOf(name);
        return port.type == "DisplayPort" || port.number == 0;
    });
}

bool isConnector(std::string_view name, const PortName& connector, int first) {
    PortName port = portOf(name);
    if (port.number.value_or(first) - first + 1 != connector.number) return false;
    if (isType(port.type, connector.type)) return true;
    // The second card's outputs under X: type, card, number.
    const PortName onCard = portOf(port.type);
    return onCard.number && port.number && isType(onCard.type, connector.type);
}

std::string sizeText(int width, int height) {
    return std::to_string(width) + "x" + std::to_string(height);
}

std::string listOf(std::span<const MonitorInfo> monitors) {
    std::string list;
    for (const MonitorInfo& monitor : monitors)
        list += (list.empty() ? "" : ", ") + monitor.name + " " +
                sizeText(monitor.width, monitor.height);
    return list;
}

bool hasSize(const MonitorInfo& monitor, const MonitorRequest& request) {
    return (request.width == 0 && request.height == 0) ||
           (monitor.width == request.width && monitor.height == request.height);
}

MonitorChoice onConnector(std::span<const MonitorInfo> monitors, const MonitorRequest& request) {
    std::vector<std::string> names;
    for (const MonitorInfo& monitor : monitors)
        names.push_back(monitor.name);
    if (const auto index = monitorOfConnector(request.connector, names)) {
        if (request.force || hasSize(monitors[*index], request)) return {*index, ""};
        throw DisplayNotFound("window: the monitor on " + request.connector + " is in mode " +
                              sizeText(monitors[*index].width, monitors[*index].height) +
                              ", not in the display's native mode " +
                              sizeText(request.width, request.height) +
                              ": set that mode, or --force to show it all the same");
    }
    const auto fits = [&](const MonitorInfo& monitor) { return hasSize(monitor, request); };
    if (std::ranges::count_if(monitors, fits) != 1)
        throw DisplayNotFound("window: cannot tell which monitor is on " + request.connector +
                              " (found: " + listOf(monitors) +
                              "): unplug or turn off the other monitors");
    const auto index =
        static_cast<std::size_t>(std::ranges::find_if(monitors, fits) - monitors.begin());
    return {index, "window: no monitor is called " + request.connector + ": taking " +
                       monitors[index].name + ", the only one of the right size"};
}

} // namespace

std::optional<std::size_t> monitorOfConnector(std::string_view connector,
                                              std::span<const std::string> monitorNames) {
    const PortName wanted = portOf(connector);
    const int first = countsFromZero(monitorNames) ? 0 : 1;
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < monitorNames.size(); ++i) {
        if (!wanted.number || !isConnector(monitorNames[i], wanted, first)) continue;
        if (found) return std::nullopt;
        found = i;
    }
    return found;
}

MonitorChoice chooseMonitor(std::span<const MonitorInfo> monitors, const MonitorRequest& request) {
    if (monitors.empty())
        throw DisplayNotFound("window: the display server has no monitor: is one connected?");
    if (!request.connector.empty()) return onConnector(monitors, request);
    const auto fitting = std::ranges::find_if(
        monitors, [&](const MonitorInfo& monitor) { return hasSize(monitor, request); });
    if (fitting != monitors.end())
        return {static_cast<std::size_t>(fitting - monitors.begin()), ""};
    if (request.force) return {};
    throw DisplayNotFound("window: no monitor is in the display's native mode " +
                          sizeText(request.width, request.height) + " (found: " + listOf(monitors) +
                          "): set that mode, or --force to show it all the same");
}

std::optional<std::string> monitorChange(const MonitorInfo& was,
                                         const std::optional<MonitorInfo>& is) {
    if (!is) return "the monitor " + was.name + " was unplugged or turned off";
    if (is->width == was.width && is->height == was.height) return std::nullopt;
    return "the monitor " + was.name + " went from " + sizeText(was.width, was.height) + " to " +
           sizeText(is->width, is->height);
}

} // namespace autostereo::gpu
