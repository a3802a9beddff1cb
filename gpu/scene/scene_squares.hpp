#pragma once

#include "gpu/panel_pass.hpp"
#include "gpu/scene/scene_surfaces.hpp"

namespace autostereo::gpu {

/// Which squares of the panel show anything of a scene, by its reference viewpoints, as an indirect
/// draw of them (Cover::StaleTiles); what is left out shows what is behind everything.
/// Thread-bound.
class SceneSquares {
  public:
    /// Throws GlError.
    SceneSquares(int panelWidth, int panelHeight, const SearchParams& search, bool upsideDown);

    /// Lists them and binds the list for the next draw. Needs what `surfaces` drew bound.
    void list();

  private:
    int across_, down_;
    gl::Program program_;
    InterleaverBlock block_;
    gl::UniformBuffer<InterleaverBlock> uniforms_;
    gl::Buffer squares_;
};

} // namespace autostereo::gpu
