#pragma once

#include "gpu/gl/objects.hpp"

namespace autostereo::gpu {

/// Which blocks of a picture are not as they were in the frame before: R8UI, a texel a block, not 0
/// where any of its texels changed. Passes mark what they write (shaders/listed_blocks.glsl).
/// Thread-bound.
class BlockMarks {
  public:
    static constexpr int kBlock = 8; ///< texels each way, and a work group's invocations
    [[nodiscard]] static int blocksOf(int texels) { return (texels + kBlock - 1) / kBlock; }

    /// For a picture of that size, in texels; nothing is marked.
    void resize(int columns, int rows);
    void clear() const;
    void markAll() const;
    /// For shaders that mark.
    void bind(GLuint imageUnit) const;
    [[nodiscard]] const gl::Texture& texture() const { return marks_; }

  private:
    gl::Texture marks_;
};

} // namespace autostereo::gpu
