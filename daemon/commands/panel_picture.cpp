#include "daemon/commands/panel_picture.hpp"

#include "calib/message_picture.hpp"
#include "gpu/picture_blit.hpp"

namespace autostereo::daemon {

namespace {

int stripHeight(const gpu::Panel& panel) { return panel.height() / 4; }

struct Rows {
    int bottom, top;
};

/// Stretched over these rows of the panel.
void blit(const calib::Picture& picture, gpu::Panel& panel, Rows rows) {
    gpu::blitPicture({picture.width, picture.height, GL_RGBA, picture.pixels}, panel.framebuffer(),
                     {rows.bottom, rows.top, panel.width()});
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
