#include "daemon/session/message_panel.hpp"

#include "calib/flat_panel.hpp"
#include "calib/message_picture.hpp"
#include "calib/panel_map.hpp"
#include "gpu/picture_blit.hpp"

namespace autostereo::daemon {

void drawMessage(const calib::Picture& background, const std::string& text,
                 const StandingTarget& target) {
    const int width = target.width, height = target.height;
    const calib::Picture panel =
        calib::flatPanel(calib::messagePicture(background, text, width, height),
                         calib::panelMap(target.display, width, height), target.display.views);
    gpu::blitPicture({width, height, GL_RGBA, panel.pixels}, target.framebuffer,
                     {0, height, width});
}

} // namespace autostereo::daemon
