#include "daemon/commands/panel_picture.hpp"

#include "calib/message_picture.hpp"
#include "gpu/gl/objects.hpp"

namespace autostereo::daemon {

namespace {

int stripHeight(const gpu::Panel& panel) { return panel.height() / 4; }

struct Rows {
    int bottom, top;
};

/// Stretched over these rows of the panel.
void blit(const calib::Picture& picture, gpu::Panel& panel, Rows rows) {
    const int width = picture.width, height = picture.height;
    const gpu::gl::Texture texture(GL_RGBA8, width, height);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(texture.name(), 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE,
                        picture.pixels.data());
    // The picture's top row lies first in the texture, GL's rows go up.
    glBlitNamedFramebuffer(gpu::gl::makeFramebuffer(texture).name(), panel.framebuffer(), 0, 0,
                           width, height, 0, rows.top, panel.width(), rows.bottom,
                           GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

} // namespace

void drawStretched(gpu::Panel& panel, const calib::Picture& picture) {
    blit(picture, panel, {0, panel.height()});
}

void drawPicture(gpu::Panel& panel, const calib::Picture& picture) {
    const int bottom = stripHeight(panel);
    blit(calib::messagePicture(picture, "", panel.width(), panel.height() - bottom), panel,
         {bottom, panel.height()});
}

void drawStrip(gpu::Panel& panel, const std::string& text) {
    blit(calib::messagePicture({}, text, panel.width(), stripHeight(panel)), panel,
         {0, stripHeight(panel)});
}

} // namespace autostereo::daemon
