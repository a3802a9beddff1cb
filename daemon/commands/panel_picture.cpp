#include "daemon/commands/panel_picture.hpp"

#include "calib/message_picture.hpp"
#include "gpu/gl/objects.hpp"

namespace autostereo::daemon {

namespace {

int stripHeight(const gpu::Panel& panel) { return panel.height() / 4; }

/// Over the panel's rows from `bottom` on.
void blit(const calib::Picture& picture, gpu::Panel& panel, int bottom) {
    const int width = picture.width, height = picture.height;
    const gpu::gl::Texture texture(GL_RGBA8, width, height);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(texture.name(), 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE,
                        picture.pixels.data());
    // The picture's top row lies first in the texture, GL's rows go up.
    glBlitNamedFramebuffer(gpu::gl::makeFramebuffer(texture).name(), panel.framebuffer(), 0, 0,
                           width, height, 0, bottom + height, width, bottom, GL_COLOR_BUFFER_BIT,
                           GL_NEAREST);
}

} // namespace

void drawPicture(gpu::Panel& panel, const calib::Picture& picture) {
    const int bottom = stripHeight(panel);
    blit(calib::messagePicture(picture, "", panel.width(), panel.height() - bottom), panel, bottom);
}

void drawStrip(gpu::Panel& panel, const std::string& text) {
    blit(calib::messagePicture({}, text, panel.width(), stripHeight(panel)), panel, 0);
}

} // namespace autostereo::daemon
