#include "calib/texel_mask.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace autostereo::calib {

namespace {

/// Texel or two of a tile that a panel pixel's centre reads along one axis.
struct Span {
    int first = 0;
    int last = 0;
};

std::vector<Span> spans(int pixels, int texels, bool neighbours) {
    std::vector<Span> found;
    for (int pixel = 0; pixel < pixels; ++pixel) {
        const int nearest = (2 * pixel + 1) * texels / (2 * pixels);
        const auto low = static_cast<int>(std::floor((pixel + 0.5) * texels / pixels - 0.5));
        found.push_back(neighbours ? Span{std::max(low, 0), std::min(low + 1, texels - 1)}
                                   : Span{nearest, nearest});
    }
    return found;
}

} // namespace

std::size_t TexelMask::texelsRead() const {
    return static_cast<std::size_t>(std::count_if(channels.begin(), channels.end(),
                                                  [](std::uint8_t bits) { return bits != 0; }));
}

std::size_t TexelMask::channelsRead() const {
    std::size_t count = 0;
    for (const std::uint8_t bits : channels)
        count += static_cast<std::size_t>(std::popcount(bits));
    return count;
}

TexelMask texelMask(const ViewMap& map, const QuiltLayout& quilt, bool neighbours) {
    const int width = map.tables.width, height = map.tables.height;
    TexelMask mask{quilt.columns * quilt.tileWidth, quilt.rows * quilt.tileHeight, {}};
    mask.channels.resize(static_cast<std::size_t>(mask.width) *
                         static_cast<std::size_t>(mask.height));
    const auto across = spans(width, quilt.tileWidth, neighbours);
    const auto up = spans(height, quilt.tileHeight, neighbours);
    const auto mark = [&](std::uint32_t view, int x, int yUp, int c) {
        const int tile = static_cast<int>(view);
        const int left = tile % quilt.columns * quilt.tileWidth;
        const int bottom = tile / quilt.columns * quilt.tileHeight;
        const Span columns = across[static_cast<std::size_t>(x)];
        const Span rows = up[static_cast<std::size_t>(yUp)];
        for (int row = rows.first; row <= rows.last; ++row)
            for (int column = columns.first; column <= columns.last; ++column) {
                const int top = mask.height - 1 - bottom - row;
                mask.channels[static_cast<std::size_t>(top) * static_cast<std::size_t>(mask.width) +
                              static_cast<std::size_t>(left + column)] |=
                    static_cast<std::uint8_t>(1U << static_cast<unsigned>(c));
            }
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c) {
                const std::uint32_t view = map.view(map.phase(x, y, c));
                const int yUp = map.upsideDown ? y : height - 1 - y;
                if (view != ViewMap::kBlack) mark(view, x, yUp, c);
            }
    return mask;
}

} // namespace autostereo::calib
