#pragma once

#include "gpu/dirty/block_lister.hpp"
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
    void forgetChanges() const;
    /// Whatever was there counts as changed.
    void markAll() const;
    /// For shaders/first_hit.glsl.
    void bind() const;

    [[nodiscard]] const gl::Texture& quads() const { return quads_; }
    /// R8UI, a texel a block, scene above background: not 0 where any corner is another one.
    [[nodiscard]] const gl::Texture& changed() const { return changed_; }
    /// The same of both layers together, of 8 x 8 texels.
    [[nodiscard]] const BlockMarks& changedBlocks() const { return changedBlocks_; }

  private:
    void resize(int columns, int rows);

    gl::Program corners_, blocks_;
    BlockLister lister_;
    BlockList stale_;
    BlockMarks changedBlocks_;
    gl::Texture quads_; ///< RGBA32F: disparity of a texel's corners; scene, background
    gl::Texture tops_;  ///< R32F: the nearest in each block
    gl::Texture changed_;
};

} // namespace autostereo::gpu
