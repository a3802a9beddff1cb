#pragma once

#include "gpu/gl/program.hpp"
#include "gpu/layer_drawer.hpp"
#include "gpu/mesh_layer.hpp"

namespace autostereo::gpu {

/// Depth at the colour camera by drawing the scene from there (de Sorbier 2010, section II.C), and
/// with it the removal of nodes that this camera cannot see, so that nobody's colour smears over
/// what stands behind them. The mesh block is bound by the caller. Thread-bound.
class ColorVisibility {
  public:
    /// Throws GlError.
    explicit ColorVisibility(const DepthMeshParams& params);
    /// Marks hidden nodes of `scene` as missing. Its indices must be built, and be built again.
    void hide(const MeshLayer& scene);
    /// R8UI per node of the scene: 1 where its colour is surely its own, away from nearer edges.
    [[nodiscard]] const gl::Texture& clean() const { return clean_; }

  private:
    LayerDrawer drawer_;
    gl::Program register_, hide_;
    gl::Texture registered_, depth_, clean_; ///< of the depth grid's size
    gl::Framebuffer framebuffer_;
};

} // namespace autostereo::gpu
