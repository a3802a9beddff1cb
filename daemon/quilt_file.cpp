#include "daemon/quilt_file.hpp"

#include "config/read_picture.hpp"
#include "daemon/command_line.hpp"
#include "devices/quilt_name.hpp"
#include "gpu/interleaver.hpp"
#include "gpu/quilt_atlas.hpp"

#include <spdlog/spdlog.h>

#include <cmath>
#include <span>

namespace autostereo::daemon {

namespace {

UsageError quiltError(const std::filesystem::path& file, const std::string& what) {
    return UsageError("quilt " + file.string() + ": " + what);
}

gpu::AtlasLayout layoutOf(const std::filesystem::path& file, const calib::Picture& picture,
                          const QuiltShape& shape) {
    const auto name = devices::quiltName(file.filename().string());
    if (!name && !(shape.columns && shape.rows))
        throw quiltError(file, "does not say its tiles (name it ..._qs8x6a0.75.png, or give "
                               "--columns and --rows)");
    const int columns = shape.columns.value_or(name ? name->columns : 0);
    const int rows = shape.rows.value_or(name ? name->rows : 0);
    const auto grid = [](int a, int b) { return std::to_string(a) + " x " + std::to_string(b); };
    if (columns > picture.width || rows > picture.height)
        throw quiltError(file, grid(columns, rows) + " tiles do not fit a picture of " +
                                   grid(picture.width, picture.height));
    gpu::AtlasLayout layout{columns * rows,
                            {columns, rows, picture.width / columns, picture.height / rows}};
    layout.views = shape.views.value_or(layout.views);
    if (layout.views > columns * rows)
        throw quiltError(file, std::to_string(layout.views) +
                                   " views are more than it has tiles (allowed 1 to " +
                                   std::to_string(columns * rows) + ')');
    const auto aspect = shape.aspect ? shape.aspect : name ? name->aspect : std::nullopt;
    const double found = static_cast<double>(layout.quilt.tileWidth) / layout.quilt.tileHeight;
    constexpr double kRounding = 0.03;
    if (aspect && std::abs(found / *aspect - 1) > kRounding)
        spdlog::warn("quilt {}: tiles are {}x{}, aspect {:.3f}, its name says {:.3f}: are columns "
                     "and rows right?",
                     file.string(), layout.quilt.tileWidth, layout.quilt.tileHeight, found,
                     *aspect);
    return layout;
}

} // namespace

Quilt readQuilt(const std::filesystem::path& file, const QuiltShape& shape) {
    Quilt quilt{config::readPicture(file), {}};
    quilt.layout = layoutOf(file, quilt.picture, shape);
    return quilt;
}

calib::DisplayProfile displayFor(const Quilt& quilt, calib::DisplayProfile display) {
    if (std::holds_alternative<calib::DepthFrame>(display.law))
        throw UsageError("quilt: " + display.name + " takes one picture and its depth, no views");
    const bool fixed = !display.remap.empty() || calib::hasFixedViews(display.law);
    if (fixed && quilt.layout.views != display.views)
        throw UsageError("quilt: " + std::to_string(quilt.layout.views) + " views, but " +
                         display.name + " shows exactly " + std::to_string(display.views) +
                         " (interleave --views leaves some out)");
    display.views = quilt.layout.views;
    return display;
}

void drawQuilt(const Quilt& quilt, const calib::DisplayProfile& display, int width, int height,
               const QuiltFilters& filters, GLuint framebuffer) {
    const calib::Picture& picture = quilt.picture;
    const gpu::Atlas atlas = gpu::quiltAtlas(
        {picture.width, picture.height, std::as_bytes(std::span(picture.pixels))}, quilt.layout);
    const bool nearest = filters.views == gpu::ViewFilter::Nearest;
    const gpu::InterleaverParams params{
        filters.texels.value_or(nearest ? gpu::TileFilter::Nearest : gpu::TileFilter::Linear),
        filters.views, display.fringe};
    gpu::makeInterleaver(calib::panelMap(display, width, height), width, height, params)
        ->render({&atlas, nullptr}, framebuffer);
}

} // namespace autostereo::daemon
