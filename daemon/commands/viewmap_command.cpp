#include "calib/panel_map.hpp"
#include "calib/texel_mask.hpp"
#include "calib/tile_view.hpp"
#include "daemon/commands/commands.hpp"
#include "daemon/log.hpp"
#include "daemon/wiring.hpp"
#include "devices/replay/image_files.hpp"
#include "devices/replay/npy_file.hpp"

#include <nlohmann/json.hpp>

#include <iostream>

namespace autostereo::daemon {

namespace {

constexpr std::uint16_t kBlack = 0xffff;

/// One number per sub-pixel, [y][x][c].
template<class Number, class Of>
void append(std::vector<Number>& numbers, PanelSize size, Of of) {
    numbers.reserve(numbers.size() + 3 * static_cast<std::size_t>(size.width) *
                                         static_cast<std::size_t>(size.height));
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            for (int c = 0; c < 3; ++c)
                numbers.push_back(of(x, y, c));
}

std::vector<std::uint16_t> views(const calib::PanelMap& map, int count, PanelSize size) {
    std::vector<std::uint16_t> found;
    if (const auto* fixed = std::get_if<calib::ViewMap>(&map))
        append(found, size, [&](int x, int y, int c) {
            return static_cast<std::uint16_t>(fixed->view(fixed->phase(x, y, c)));
        });
    else if (const auto* bands = std::get_if<calib::BandMap>(&map))
        append(found, size, [&](int x, int y, int c) {
            for (std::size_t eye = 0; eye < bands->eyes.size(); ++eye)
                if (bands->lit(eye, x, y, c)) return static_cast<std::uint16_t>(eye);
            return kBlack;
        });
    else if (const auto* tiles = std::get_if<calib::TileFrame>(&map))
        append(found, size, [&](int x, int y, int /*c*/) {
            const int view = calib::tileView(*tiles, count, size.width, size.height, x, y);
            return view < 0 ? kBlack : static_cast<std::uint16_t>(view);
        });
    return found;
}

template<class Number>
void write(const std::filesystem::path& file, const char* type, std::size_t layers, bool layered,
           PanelSize size, const std::vector<Number>& numbers) {
    devices::NpyHeader header{
        type, {static_cast<std::size_t>(size.height), static_cast<std::size_t>(size.width), 3}};
    if (layered) header.shape.insert(header.shape.begin(), layers);
    devices::writeNpy(file, header, std::as_bytes(std::span(numbers)));
}

void writePhases(const ViewmapOptions& options, const calib::PanelMap& map, PanelSize size) {
    std::vector<std::uint32_t> phases;
    const auto add = [&](const calib::PhaseTables& tables) {
        append(phases, size, [&](int x, int y, int c) { return tables.phase(x, y, c); });
    };
    const auto* bands = std::get_if<calib::BandMap>(&map);
    if (bands != nullptr)
        for (const calib::PhaseTables& eye : bands->eyes)
            add(eye);
    else if (const auto* fixed = std::get_if<calib::ViewMap>(&map))
        add(fixed->tables);
    else
        throw UsageError("--display: " + options.display + " has no phase, only views (--index)");
    write(options.output, "<u4", bands != nullptr ? bands->eyes.size() : 1, bands != nullptr, size,
          phases);
}

/// Writes the mask; its counters.
nlohmann::json writeTexels(const std::filesystem::path& file, const calib::PanelMap& map,
                           const calib::DisplayProfile& display) {
    const auto* fixed = std::get_if<calib::ViewMap>(&map);
    if (fixed == nullptr)
        throw UsageError("--texels: " + display.name +
                         " does not show the same texels for every eye");
    const calib::TexelMask mask = calib::texelMask(*fixed, display.quilt, false);
    std::vector<std::uint8_t> pixels;
    pixels.reserve(3 * mask.channels.size());
    for (const std::uint8_t bits : mask.channels)
        for (unsigned c = 0; c < 3; ++c)
            pixels.push_back((bits >> c & 1U) != 0 ? 255 : 0);
    devices::writePng(file, {{devices::ImageFormat::Rgb8, mask.width, mask.height},
                             std::as_bytes(std::span(pixels))});
    const auto all = static_cast<double>(mask.channels.size());
    return {{"total", mask.channels.size()},
            {"read", mask.texelsRead()},
            {"read_share", static_cast<double>(mask.texelsRead()) / all},
            {"channels_read", mask.channelsRead()},
            {"channels_read_share", static_cast<double>(mask.channelsRead()) / (3 * all)}};
}

} // namespace

int viewmap(const ViewmapOptions& options) {
    setUpLog("warn");
    const calib::DisplayProfile display = config::loadDisplay(options.display);
    warnOfPlaceholder(display);
    const PanelSize size = offscreenSize(display);
    const calib::PanelMap map = calib::panelMap(display, size.width, size.height, options.eyes);
    if (std::holds_alternative<calib::DepthFrame>(map))
        throw UsageError("--display: " + display.name +
                         " takes one picture and its depth, no views");
    if (!options.eyes.empty() && !std::holds_alternative<calib::BandMap>(map))
        throw UsageError("--eye: the views of " + display.name + " do not depend on it");
    nlohmann::json counters{{"display", display.name},
                            {"width", size.width},
                            {"height", size.height},
                            {"views", display.views},
                            {"placeholder", display.placeholder}};
    if (options.texels) counters["texels"] = writeTexels(*options.texels, map, display);
    if (options.index)
        write(options.output, "<u2", 1, false, size, views(map, display.views, size));
    else
        writePhases(options, map, size);
    if (options.json) std::cout << counters.dump(2) << '\n';
    return EXIT_SUCCESS;
}

} // namespace autostereo::daemon
