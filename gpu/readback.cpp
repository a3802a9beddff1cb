#include "gpu/readback.hpp"

#include <cstddef>

namespace autostereo::gpu {

RgbImage readFramebuffer(GLuint framebuffer, int width, int height) {
    RgbImage image{width, height, {}};
    const std::size_t stride = 3 * static_cast<std::size_t>(width);
    image.pixels.resize(stride * static_cast<std::size_t>(height));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, image.pixels.data());
    flipRows(image.pixels, stride);
    return image;
}

RgbImage crop(const RgbImage& image, int x, int y, int width, int height) {
    RgbImage part{width, height, {}};
    part.pixels.reserve(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int row = y; row < y + height; ++row) {
        const auto first =
            image.pixels.begin() + 3 * (static_cast<std::ptrdiff_t>(row) * image.width + x);
        part.pixels.insert(part.pixels.end(), first,
                           first + 3 * static_cast<std::ptrdiff_t>(width));
    }
    return part;
}

} // namespace autostereo::gpu
