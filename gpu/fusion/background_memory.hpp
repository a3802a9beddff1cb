#pragma once

#include "gpu/gl/program.hpp"

namespace autostereo::gpu {

/// Background gathered over time where a camera that stands still has seen it: the farthest surface
/// of each texel and its colour. Forgets all when much of the picture steps back at once (somebody
/// moved the camera). Needs MeshBlock at binding 0. Thread-bound.
class BackgroundMemory {
  public:
    BackgroundMemory();
    void resize(int columns, int rows);
    void forget() const;

    void remember(const gl::Texture& sure, const gl::Texture& picture) const;
    [[nodiscard]] const gl::Texture& depth() const { return depth_; } ///< R32F, m; 0: nothing
    [[nodiscard]] const gl::Texture& color() const { return color_; } ///< RGBA8, alpha: trust

  private:
    gl::Program program_;
    gl::Texture depth_, color_;
    gl::Buffer tally_;
};

} // namespace autostereo::gpu
