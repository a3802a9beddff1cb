#pragma once

#include "gpu/gl/api.hpp"

#include <cstdint>
#include <span>

namespace autostereo::gpu {

/// A picture in memory: 8 bits a channel, tightly packed, top row first.
struct PixelPicture {
    int width = 0;
    int height = 0;
    GLenum format = GL_RGBA; ///< or GL_RGB
    std::span<const std::uint8_t> pixels;
};

/// Of a framebuffer, GL's rows (y up).
struct BlitArea {
    int bottom, top, width;
};

/// Stretched over an area, nearest pixels. Throws GlError.
void blitPicture(const PixelPicture& picture, GLuint framebuffer, const BlitArea& area);

} // namespace autostereo::gpu
