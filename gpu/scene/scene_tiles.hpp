#pragma once

#include "gpu/panel_pass.hpp"
#include "gpu/panel_tiles.hpp"
#include "gpu/scene/scene_surfaces.hpp"

namespace autostereo::gpu {

/// Which tiles of the panel show anything of a scene, by its reference viewpoints; what is left out
/// shows what is behind everything. Thread-bound.
class SceneTiles {
  public:
    /// Throws GlError.
    SceneTiles(int panelWidth, int panelHeight, const SearchParams& search, bool upsideDown);

    /// Lists them and binds the list for the next draw. Needs what `surfaces` drew bound.
    void list();

  private:
    gl::Program program_;
    InterleaverBlock block_;
    gl::UniformBuffer<InterleaverBlock> uniforms_;
    PanelTiles tiles_;
};

} // namespace autostereo::gpu
