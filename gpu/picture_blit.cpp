#include "gpu/picture_blit.hpp"

#include "gpu/gl/objects.hpp"

namespace autostereo::gpu {

void blitPicture(const PixelPicture& picture, GLuint framebuffer, const BlitArea& area) {
    const gl::Texture texture(GL_RGBA8, picture.width, picture.height);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(texture.name(), 0, 0, 0, picture.width, picture.height, picture.format,
                        GL_UNSIGNED_BYTE, picture.pixels.data());
    // The picture's top row lies first in the texture, GL's rows go up.
    glBlitNamedFramebuffer(gl::makeFramebuffer(texture).name(), framebuffer, 0, 0, picture.width,
                           picture.height, 0, area.top, area.width, area.bottom,
                           GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

} // namespace autostereo::gpu
