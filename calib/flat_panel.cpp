#include "calib/flat_panel.hpp"

#include "calib/depth_frame_header.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace autostereo::calib {

namespace {

Picture black(int width, int height) {
    Picture panel{width, height, {}};
    panel.pixels.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (std::size_t i = 3; i < panel.pixels.size(); i += 4)
        panel.pixels[i] = 255;
    return panel;
}

/// The picture, `columns` by `rows` times smaller, with its corner at (left, top).
void shrinkInto(Picture& panel, const Picture& picture, int columns, int rows, int left, int top) {
    const int width = picture.width / columns, height = picture.height / rows;
    const auto count = static_cast<std::uint32_t>(columns) * static_cast<std::uint32_t>(rows);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (std::size_t c = 0; c < 3; ++c) {
                std::uint32_t sum = 0;
                for (int v = y * rows; v < (y + 1) * rows; ++v)
                    for (int u = x * columns; u < (x + 1) * columns; ++u)
                        sum += picture.pixels[picture.offset(u, v) + c];
                panel.pixels[panel.offset(left + x, top + y) + c] =
                    static_cast<std::uint8_t>((sum + count / 2) / count);
            }
}

Picture onViews(const Picture& picture, const ViewMap& map) {
    Picture panel = picture;
    const auto stride = 4 * static_cast<std::ptrdiff_t>(picture.width);
    if (map.upsideDown)
        for (int low = 0, high = picture.height - 1; low < high; ++low, --high)
            std::swap_ranges(panel.pixels.begin() + low * stride,
                             panel.pixels.begin() + (low + 1) * stride,
                             panel.pixels.begin() + high * stride);
    if (std::ranges::find(map.remap, ViewMap::kBlack) == map.remap.end()) return panel;
    for (int y = 0; y < panel.height; ++y)
        for (int x = 0; x < panel.width; ++x)
            for (int c = 0; c < 3; ++c)
                if (map.view(map.phase(x, y, c)) == ViewMap::kBlack)
                    panel.pixels[panel.offset(x, y) + static_cast<std::size_t>(c)] = 0;
    return panel;
}

Picture onTiles(const Picture& picture, const TileFrame& frame, int views) {
    Picture panel = black(picture.width, picture.height);
    const int width = picture.width / frame.columns, height = picture.height / frame.rows;
    for (int view = 0; view < std::min(views, frame.columns * frame.rows); ++view) {
        const int row = view / frame.columns;
        const int top = frame.topFirst ? row * height : panel.height - (row + 1) * height;
        shrinkInto(panel, picture, frame.columns, frame.rows, view % frame.columns * width, top);
    }
    return panel;
}

Picture onDepthFrame(const Picture& picture, const DepthFrame& frame) {
    Picture panel = black(picture.width, picture.height);
    shrinkInto(panel, picture, 2, 1, 0, 0);
    const auto grey = static_cast<std::uint8_t>(std::lround(frame.screenLevel));
    for (int y = 0; y < panel.height; ++y)
        for (int x = panel.width / 2; x < panel.width; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                panel.pixels[panel.offset(x, y) + c] = grey;
    if (!frame.header) return panel;
    int x = 0;
    for (const std::uint8_t level : depthFrameHeaderRow(frame))
        if (x < panel.width) panel.pixels[panel.offset(x++, 0) + 2] = level;
    return panel;
}

} // namespace

Picture flatPanel(const Picture& picture, const PanelMap& map, int views) {
    struct Visitor {
        const Picture& picture;
        int views;
        Picture operator()(const ViewMap& viewMap) const { return onViews(picture, viewMap); }
        Picture operator()(const BandMap& /*bands*/) const { return picture; }
        Picture operator()(const TileFrame& frame) const { return onTiles(picture, frame, views); }
        Picture operator()(const DepthFrame& frame) const { return onDepthFrame(picture, frame); }
    };
    return std::visit(Visitor{picture, views}, map);
}

} // namespace autostereo::calib
