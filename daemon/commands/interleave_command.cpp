#include "daemon/commands/commands.hpp"
#include "daemon/commands/quilt_name.hpp"
#include "daemon/log.hpp"
#include "daemon/picture_files.hpp"
#include "daemon/wiring.hpp"
#include "devices/input.hpp"
#include "devices/replay/image_files.hpp"
#include "gpu/interleaver.hpp"
#include "gpu/offscreen_panel.hpp"
#include "gpu/quilt_atlas.hpp"

#include <spdlog/spdlog.h>

#include <cmath>

namespace autostereo::daemon {

namespace {

struct Quilt {
    devices::ImageHeader header;
    std::vector<std::byte> pixels;
};

Quilt readQuilt(const std::filesystem::path& file) {
    devices::ImageReader reader;
    Quilt quilt{reader.open(file), {}};
    if (quilt.header.format != devices::ImageFormat::Rgba8)
        throw UsageError("--quilt: " + file.string() +
                         " is 16-bit grey (allowed 8-bit PNG or JPEG)");
    quilt.pixels.resize(quilt.header.bytes());
    reader.decode(quilt.pixels);
    return quilt;
}

/// Columns and rows from the options, else from the file's name.
gpu::AtlasLayout layoutOf(const InterleaveOptions& options, const devices::ImageHeader& picture) {
    const auto name = quiltName(options.quilt.filename().string());
    if (!name && !(options.columns && options.rows))
        throw UsageError("--quilt: " + options.quilt.string() +
                         " does not say its tiles (name it ..._qs8x6a0.75.png, or give --columns "
                         "and --rows)");
    const int columns = options.columns.value_or(name ? name->columns : 0);
    const int rows = options.rows.value_or(name ? name->rows : 0);
    if (columns > picture.width || rows > picture.height)
        throw UsageError("--quilt: " + std::to_string(columns) + " x " + std::to_string(rows) +
                         " tiles do not fit a picture of " + picture.size().text());
    gpu::AtlasLayout layout{columns * rows,
                            {columns, rows, picture.width / columns, picture.height / rows}};
    layout.views = options.views.value_or(layout.views);
    if (layout.views > columns * rows)
        throw UsageError("--views: " + std::to_string(layout.views) +
                         " is more than the quilt has "
                         "tiles (allowed 1 to " +
                         std::to_string(columns * rows) + ')');
    const auto aspect = options.aspect ? options.aspect : name ? name->aspect : std::nullopt;
    const double found = static_cast<double>(layout.quilt.tileWidth) / layout.quilt.tileHeight;
    constexpr double kRounding = 0.03;
    if (aspect && std::abs(found / *aspect - 1) > kRounding)
        spdlog::warn("quilt {}: tiles are {}x{}, aspect {:.3f}, its name says {:.3f}: are columns "
                     "and rows right?",
                     options.quilt.string(), layout.quilt.tileWidth, layout.quilt.tileHeight, found,
                     *aspect);
    return layout;
}

/// The display with the quilt's number of views, where its glass does not fix that.
calib::DisplayProfile displayFor(const InterleaveOptions& options, int views) {
    calib::DisplayProfile display = config::loadDisplay(options.display);
    if (std::holds_alternative<calib::DepthFrame>(display.law))
        throw UsageError("--display: " + display.name +
                         " takes one picture and its depth, no views");
    const bool fixed = !display.remap.empty() || calib::hasFixedViews(display.law);
    if (fixed && views != display.views)
        throw UsageError("--quilt: " + std::to_string(views) + " views, but " + display.name +
                         " shows exactly " + std::to_string(display.views) + " (see --views)");
    display.views = views;
    return display;
}

} // namespace

int interleave(const InterleaveOptions& options) {
    setUpLog("info");
    // What the command line and the display say comes before a picture of some hundred megabytes.
    static_cast<void>(config::loadDisplay(options.display));
    const Quilt quilt = readQuilt(options.quilt);
    const gpu::AtlasLayout layout = layoutOf(options, quilt.header);
    const calib::DisplayProfile display = displayFor(options, layout.views);
    warnOfPlaceholder(display);

    const PanelSize size = offscreenSize(display);
    gpu::OffscreenPanel panel(size.width, size.height, false);
    const gpu::Atlas atlas =
        gpu::quiltAtlas({quilt.header.width, quilt.header.height, quilt.pixels}, layout);
    const bool nearest = options.filter == gpu::ViewFilter::Nearest;
    const gpu::InterleaverParams params{
        options.texels.value_or(nearest ? gpu::TileFilter::Nearest : gpu::TileFilter::Linear),
        options.filter, display.fringe};
    gpu::makeInterleaver(calib::panelMap(display, size.width, size.height), size.width, size.height,
                         params)
        ->render({&atlas, nullptr}, panel.framebuffer());
    writePicturePng(options.output,
                    gpu::readFramebuffer(panel.framebuffer(), size.width, size.height));
    return EXIT_SUCCESS;
}

} // namespace autostereo::daemon
