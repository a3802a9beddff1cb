#pragma once

#include "gpu/gl/objects.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace autostereo::gpu {

/// 8-bit RGB, tightly packed, top row first.
struct RgbImage {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> pixels;
};

/// Rows of `stride` values each, in opposite order: the one place where GL's rows (y up) turn into
/// an image's (top row first).
template<class Value>
void flipRows(std::vector<Value>& values, std::size_t stride) {
    for (std::size_t low = 0, high = values.size() / stride; low + 1 < high; ++low) {
        --high;
        std::swap_ranges(values.begin() + static_cast<std::ptrdiff_t>(low * stride),
                         values.begin() + static_cast<std::ptrdiff_t>((low + 1) * stride),
                         values.begin() + static_cast<std::ptrdiff_t>(high * stride));
    }
}

/// Waits for the GPU and copies a framebuffer. Not for production passes.
[[nodiscard]] RgbImage readFramebuffer(GLuint framebuffer, int width, int height);

/// Part of an image, as an image.
[[nodiscard]] RgbImage crop(const RgbImage& image, int x, int y, int width, int height);

} // namespace autostereo::gpu
