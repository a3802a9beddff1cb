#pragma once

#include "gpu/fusion/cyclopean_scene.hpp"

#include <array>

namespace autostereo::daemon {

/// A cyclopean scene of fewer texels, for pictures that are small themselves: every n-th texel each
/// way of depth and background; colour stays the camera's own. Thread-bound.
class CoarseScene {
  public:
    /// So many texels at most.
    explicit CoarseScene(int mostTexels) : mostTexels_(mostTexels) {}

    /// Of the scene as it is now; valid until the next call. Throws GlError.
    [[nodiscard]] gpu::CyclopeanScene of(const gpu::CyclopeanScene& scene);

  private:
    /// One of its textures, and a frame around it to copy into.
    struct Copy {
        gpu::gl::Texture texture;
        gpu::gl::Framebuffer frame;

        void take(const gpu::gl::Texture& from, GLenum format, int width, int height);
    };
    int mostTexels_;
    Copy depth_, backgroundDepth_, backgroundColor_;
};

} // namespace autostereo::daemon
