#pragma once

#include "gpu/dirty/block_lister.hpp"

namespace autostereo::gpu {

/// Background gathered over time where a camera that stands still has seen it: the farthest surface
/// of each texel and its colour. Forgets all when much of the picture steps back at once (somebody
/// moved the camera). Needs MeshBlock at binding 0. Thread-bound.
class BackgroundMemory {
  public:
    BackgroundMemory();
    void resize(int columns, int rows);
    void forget();

    /// `sureMarks`, `pictureMarks`: blocks of the grid in which these differ from last time's; what
    /// has not settled since is seen to as well. `everything`: all may differ.
    void remember(const gl::Texture& sure, const BlockMarks& sureMarks, const gl::Texture& picture,
                  const BlockMarks& pictureMarks, BlockLister& lister, bool everything);
    [[nodiscard]] const gl::Texture& depth() const { return depth_; } ///< R32F, m; 0: nothing
    [[nodiscard]] const gl::Texture& color() const { return color_; } ///< RGBA8, alpha: trust
    [[nodiscard]] const BlockMarks& changed() const { return changed_; }

  private:
    void sumUp() const;

    gl::Program program_, reset_, sum_, moved_;
    gl::Texture depth_, color_;
    BlockMarks changed_;
    BlockList list_;
    gl::Buffer tally_;
    bool forgot_ = false;
};

} // namespace autostereo::gpu
