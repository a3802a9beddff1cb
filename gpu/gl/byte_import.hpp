#pragma once

#include "gpu/gl/objects.hpp"

#include <optional>
#include <string>

namespace autostereo::gpu::gl {

/// Why the current context cannot import memory of other devices'; none: it can.
[[nodiscard]] std::optional<std::string> importProblem();
/// The card behind the current context, "/dev/dri/card0"; empty: it says none.
[[nodiscard]] std::string cardNode();

/// Rows of bytes in a dmabuf as a texture, one R8 texel a byte, without a copy: what is written
/// there later is what is sampled then (EGL_EXT_image_dma_buf_import). Single bytes, because every
/// driver takes them, while few take YUYV. Keeps the memory; movable, thread-bound.
class ByteImport {
  public:
    /// `fd` stays the caller's. Throws GlError.
    ByteImport(int fd, int rowBytes, int rows);
    [[nodiscard]] GLuint name() const { return texture_.name(); }

  private:
    Handle<deleteTexture> texture_;
};

} // namespace autostereo::gpu::gl
