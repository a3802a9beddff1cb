#pragma once

#include "gpu/mesh_layer.hpp"
#include "gpu/registered_depth.hpp"

namespace autostereo::gpu {

/// Depth at the colour camera by drawing the scene from there (de Sorbier 2010, section II.C), and
/// with it the removal of nodes that this camera cannot see, so that nobody's colour smears over
/// what stands behind them. The mesh block is bound by the caller. Thread-bound.
class ColorVisibility {
  public:
    /// Throws GlError.
    ColorVisibility();
    /// Marks hidden nodes of `scene` as missing; `counts`: those that it was made of.
    void hide(const MeshLayer& scene, const gl::Texture& counts);
    /// R8UI per node of the scene: 1 where its colour is surely its own, away from nearer edges.
    [[nodiscard]] const gl::Texture& clean() const { return clean_; }

  private:
    RegisteredDepth registered_; ///< at the depth grid's size
    gl::Program drawMesh_, hide_;
    gl::Texture clean_;
};

} // namespace autostereo::gpu
