#pragma once

#include "gpu/gl/objects.hpp"

#include <cstdint>
#include <vector>

namespace autostereo::gpu {

/// 8-bit RGB, tightly packed, top row first.
struct RgbImage {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> pixels;
};

/// Waits for the GPU and copies a framebuffer; the one place where GL's rows (y up) turn into an
/// image's (top row first). Not for production passes.
[[nodiscard]] RgbImage readFramebuffer(GLuint framebuffer, int width, int height);

/// Part of an image, as an image.
[[nodiscard]] RgbImage crop(const RgbImage& image, int x, int y, int width, int height);

} // namespace autostereo::gpu
