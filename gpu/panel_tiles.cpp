#include "gpu/panel_tiles.hpp"

#include <array>
#include <cstdint>

namespace autostereo::gpu {

namespace {

constexpr int kTileWidth = 64, kTileHeight = 16;             // as in shaders/stale_tiles.glsl
constexpr std::array<std::uint32_t, 4> kNoTiles{4, 0, 0, 0}; // corners, tiles, firsts

int tilesOf(int pixels, int tile) { return (pixels + tile - 1) / tile; }

} // namespace

PanelTiles::PanelTiles(int panelWidth, int panelHeight)
    : across_(tilesOf(panelWidth, kTileWidth)), down_(tilesOf(panelHeight, kTileHeight)),
      list_(gl::makeBuffer(sizeof kNoTiles + sizeof(std::uint32_t) *
                                                 static_cast<std::size_t>(across_) *
                                                 static_cast<std::size_t>(down_),
                           nullptr, GL_DYNAMIC_STORAGE_BIT)) {}

void PanelTiles::clear() const {
    glNamedBufferSubData(list_.name(), 0, sizeof kNoTiles, kNoTiles.data());
}

void PanelTiles::bind(GLuint binding) const {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, list_.name());
}

void PanelTiles::bindToDraw() const {
    bind(2);
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, list_.name());
}

} // namespace autostereo::gpu
