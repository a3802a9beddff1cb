#include "devices/display/connectors.hpp"

#include "devices/display/bounded_file.hpp"

#include <algorithm>
#include <charconv>
#include <sstream>
#include <tuple>

namespace autostereo::devices {

namespace {

constexpr std::size_t kMostBytes = 64U << 10U;
constexpr int kLargestSide = 65535;

/// "1920x1080"; interlaced modes end in "i" and are none of ours.
std::optional<Connector::Mode> modeOf(const std::string& line) {
    Connector::Mode mode;
    const char* end = line.data() + line.size();
    const auto width = std::from_chars(line.data(), end, mode.width);
    if (width.ec != std::errc{} || width.ptr == end || *width.ptr != 'x') return std::nullopt;
    const auto height = std::from_chars(width.ptr + 1, end, mode.height);
    if (height.ec != std::errc{} || height.ptr != end) return std::nullopt;
    if (std::min(mode.width, mode.height) < 1 || std::max(mode.width, mode.height) > kLargestSide)
        return std::nullopt;
    return mode;
}

std::vector<Connector::Mode> modesOf(const std::string& text) {
    std::vector<Connector::Mode> modes;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) // one line for each refresh rate
        if (const auto mode = modeOf(line); mode && std::ranges::find(modes, *mode) == modes.end())
            modes.push_back(*mode);
    return modes;
}

void addEdid(const std::string& bytes, Connector& connector) {
    if (bytes.empty()) {
        connector.edidProblem = "the monitor sends no EDID: check its cable and adapter";
        return;
    }
    auto parsed = parseEdid(std::as_bytes(std::span(bytes)));
    if (auto* edid = std::get_if<Edid>(&parsed))
        connector.edid = std::move(*edid);
    else
        connector.edidProblem = std::get<EdidError>(parsed).text;
}

/// The folder is called card0-HDMI-A-1.
std::optional<Connector> connectorAt(const std::filesystem::path& folder) {
    const std::string name = folder.filename();
    const auto dash = name.find('-');
    if (!name.starts_with("card") || dash == std::string::npos) return std::nullopt;
    const auto status = readBoundedFile(folder / "status", kMostBytes);
    if (!status || !status->starts_with("connected")) return std::nullopt;
    Connector connector;
    connector.card = name.substr(0, dash);
    connector.name = name.substr(dash + 1);
    connector.enabled =
        readBoundedFile(folder / "enabled", kMostBytes).value_or("").starts_with("enabled");
    connector.modes = modesOf(readBoundedFile(folder / "modes", kMostBytes).value_or(""));
    addEdid(readBoundedFile(folder / "edid", kMostBytes).value_or(""), connector);
    return connector;
}

} // namespace

bool Connector::offers(int width, int height) const {
    if (edid && !edid->interlaced && edid->nativeWidth == width && edid->nativeHeight == height)
        return true;
    return std::ranges::find(modes, Mode{width, height}) != modes.end();
}

std::vector<Connector> connectedMonitors(const std::filesystem::path& root) {
    std::vector<Connector> found;
    std::error_code error;
    std::filesystem::directory_iterator entry(root / "sys/class/drm", error);
    for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error))
        if (auto connector = connectorAt(entry->path())) found.push_back(std::move(*connector));
    std::ranges::sort(found, {}, [](const Connector& one) { return std::tie(one.card, one.name); });
    return found;
}

} // namespace autostereo::devices
