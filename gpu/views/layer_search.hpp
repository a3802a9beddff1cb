#pragma once

#include "gpu/fusion/cyclopean_scene.hpp"
#include "gpu/gl/program.hpp"

#include <cstdint>

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
    /// What changed from here on counts as new; before, changes add up from build to build.
    void forgetChanges();
    /// For shaders/first_hit.glsl.
    void bind() const;

    [[nodiscard]] const gl::Texture& quads() const { return quads_; }
    /// R8UI, a texel a block, scene above background: not 0 where any corner is another one.
    [[nodiscard]] const gl::Texture& changed() const { return changed_; }

  private:
    void resize(int columns, int rows);
    void markBlocks(std::uint8_t mark) const;

    gl::Program corners_, blocks_;
    gl::Texture quads_; ///< RGBA32F: disparity of a texel's corners; scene, background
    gl::Texture tops_;  ///< R32F: the nearest in each block
    gl::Texture changed_;
};

} // namespace autostereo::gpu
