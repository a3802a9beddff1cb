#pragma once

#include "gpu/gl/objects.hpp"

namespace autostereo::gpu {

/// Pieces of the panel, as a shader lists them for the indirect draw that fills them
/// (Cover::StaleTiles, shaders/stale_tiles.glsl). Thread-bound.
class PanelTiles {
  public:
    /// Of a panel of that size. Throws GlError.
    PanelTiles(int panelWidth, int panelHeight);

    [[nodiscard]] int across() const { return across_; }
    [[nodiscard]] int down() const { return down_; }
    void clear() const;
    /// To be listed in the storage buffer `binding`.
    void bind(GLuint binding) const;
    /// For the next draw.
    void bindToDraw() const;

  private:
    int across_, down_;
    gl::Buffer list_; ///< the indirect draw, then one number a tile
};

} // namespace autostereo::gpu
