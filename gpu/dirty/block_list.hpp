#pragma once

#include "gpu/dirty/block_marks.hpp"
#include "gpu/gl/program.hpp"

#include <vector>

namespace autostereo::gpu {

/// Blocks of a picture that a pass has to do, one work group each: all of them, or what a
/// BlockLister found. The GPU counts them, nobody waits. Thread-bound.
class BlockList {
  public:
    /// For a picture of that size, in texels; lists all.
    void resize(int columns, int rows);
    void listAll() { listsAll_ = true; }
    /// Runs a program that includes shaders/listed_blocks.glsl. What was written before is seen.
    void dispatch(const gl::Program& program) const;

    /// Draws a point for each (shaders/cleared_blocks.vert), with the program in use.
    void drawPoints() const;
    /// For shaders that list themselves: an empty list at binding 6.
    void beginFinding();

    [[nodiscard]] int across() const { return across_; }
    [[nodiscard]] int down() const { return down_; }

  private:
    int across_ = 0, down_ = 0;
    bool listsAll_ = true;
    /// Indirect dispatch, blocks across, then a number a block. As an indirect draw: so many
    /// vertices from 1 on, once.
    gl::Buffer all_, found_;
};

} // namespace autostereo::gpu
