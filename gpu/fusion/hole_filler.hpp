#pragma once

#include "gpu/blocks.hpp"
#include "gpu/gl/program.hpp"
#include "gpu/gl/uniform_buffer.hpp"

namespace autostereo::gpu {

/// Measured depth on the cyclopean grid -> depth wherever the colour picture shows something: what
/// is too close to an edge to be sure is taken out, holes are filled from their row and column, and
/// at edges colours decide between the surfaces.
/// Needs MeshBlock at binding 0. Thread-bound.
class HoleFiller {
  public:
    HoleFiller();
    void resize(int columns, int rows);

    /// Leaves the block at binding 3.
    void fill(const gl::Texture& measured, const gl::Texture& color, const FillBlock& block);
    /// R32F, metres; 0: none.
    [[nodiscard]] const gl::Texture& depth() const { return filled_; }
    /// The same without what was filled.
    [[nodiscard]] const gl::Texture& sureDepth() const { return sure_; }

  private:
    gl::Program band_, fill_;
    gl::UniformBuffer<FillBlock> uniforms_;
    gl::Texture sure_, filled_;
};

} // namespace autostereo::gpu
