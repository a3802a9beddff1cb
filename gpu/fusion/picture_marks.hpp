#pragma once

#include "gpu/dirty/block_marks.hpp"
#include "gpu/gl/program.hpp"

namespace autostereo::gpu {

/// From blocks of the colour camera's picture to the blocks of the cyclopean grid that show them.
/// Needs MeshBlock at binding 0. Thread-bound.
class PictureMarks {
  public:
    PictureMarks();
    void resize(int columns, int rows);
    /// Which part of the picture every block of the grid shows: once for a rig and a framing.
    void place() const;
    /// Marks what shows a marked block of the picture, here and in `too`.
    void mark(const BlockMarks& picture, const BlockMarks& too) const;
    void clear() const { marks_.clear(); }
    [[nodiscard]] const BlockMarks& marks() const { return marks_; }

  private:
    gl::Program bounds_, mark_;
    gl::Texture places_; ///< RGBA16UI, a texel a block: first and last block of the picture
    BlockMarks marks_;
};

} // namespace autostereo::gpu
