#pragma once

#include "calib/panel_map.hpp"
#include "gpu/interleaver.hpp"
#include "gpu/readback.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <vector>

// Views that say which they are: panels made of them show what an interleaver decided.

namespace autostereo::test {

inline constexpr int kStep = 2; // levels from one view to the next

inline int levelOf(int view) { return view < 0 ? 0 : kStep * view + 3; }

/// Every texel of view i's tile holds levelOf(i). Tiles of a few texels: neighbours must not leak
/// in with either filter.
inline gpu::Atlas numberedAtlas(int views) {
    const int columns = 10, rows = (views + columns - 1) / columns;
    gpu::AtlasLayout layout{views, {columns, rows, 7, 5}};
    gpu::Atlas atlas(layout);
    std::vector<std::uint8_t> texels;
    for (int y = 0; y < layout.height(); ++y)
        for (int x = 0; x < layout.width(); ++x)
            texels.insert(texels.end(), 4,
                          static_cast<std::uint8_t>(levelOf(y / 5 * columns + x / 7)));
    glTextureSubImage2D(atlas.color().name(), 0, 0, 0, layout.width(), layout.height(), GL_RGBA,
                        GL_UNSIGNED_BYTE, texels.data());
    return atlas;
}

inline gpu::RgbImage interleavedFrom(const gpu::Atlas& atlas, const calib::PanelMap& map, int width,
                                     int height, const gpu::InterleaverParams& params) {
    const gpu::gl::Texture target(GL_RGBA8, width, height);
    const gpu::gl::Framebuffer panel = gpu::gl::makeFramebuffer(target);
    gpu::makeInterleaver(map, width, height, params)->render({&atlas, nullptr}, panel.name());
    return gpu::readFramebuffer(panel.name(), width, height);
}

inline gpu::RgbImage interleaved(const calib::PanelMap& map, int width, int height, int views,
                                 const gpu::InterleaverParams& params) {
    return interleavedFrom(numberedAtlas(views), map, width, height, params);
}

/// Sub-pixels that do not show the level that `expected(x, y, c)` says.
inline std::size_t differences(const gpu::RgbImage& image,
                               const std::function<int(int, int, int)>& expected) {
    std::size_t at = 0, wrong = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (int c = 0; c < 3; ++c)
                wrong += image.pixels[at++] != expected(x, y, c);
    return wrong;
}

inline int levelOf(const calib::ViewMap& map, int x, int y, int c) {
    const std::uint32_t view = map.view(map.phase(x, y, c));
    return view == calib::ViewMap::kBlack ? 0 : levelOf(static_cast<int>(view));
}

/// The brightest of the eyes that a sub-pixel is lit for.
inline int levelOf(const calib::BandMap& map, int x, int y, int c) {
    int level = 0;
    for (std::size_t eye = 0; eye < map.eyes.size(); ++eye)
        if (map.lit(eye, x, y, c)) level = std::max(level, levelOf(static_cast<int>(eye)));
    return level;
}

} // namespace autostereo::test
