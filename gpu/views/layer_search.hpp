#pragma once

#include "gpu/fusion/cyclopean_scene.hpp"
#include "gpu/gl/program.hpp"

namespace autostereo::gpu {

/// The layers, ready to be searched for the first surface behind a sub-pixel
/// (shaders/first_hit.glsl). Needs MeshBlock at binding 0. Thread-bound.
class LayerSearch {
  public:
    /// Texels of a row whose largest disparity is known; as in shaders/layer_search.glsl.
    static constexpr int kBlock = 4;

    /// Throws GlError.
    LayerSearch();
    void build(const CyclopeanScene& scene);
    /// For shaders/first_hit.glsl.
    void bind() const;

    [[nodiscard]] const gl::Texture& quads() const { return quads_; }

  private:
    void resize(int columns, int rows);

    gl::Program corners_, blocks_;
    gl::Texture quads_; ///< RGBA32F: disparity of a texel's corners; scene, background
    gl::Texture tops_;  ///< R32F: the nearest in each block
};

} // namespace autostereo::gpu
