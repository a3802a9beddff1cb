#include "daemon/commands/commands.hpp"
#include "daemon/log.hpp"
#include "daemon/picture_files.hpp"
#include "daemon/session/pattern_picture.hpp"
#include "daemon/wiring.hpp"
#include "gpu/offscreen_panel.hpp"

namespace autostereo::daemon {

int pattern(const PatternOptions& options) {
    setUpLog("info");
    const Pattern pattern = patternNamed(options.name);
    const calib::DisplayProfile display = config::loadDisplay(options.display);
    warnOfPlaceholder(display);

    const PanelSize size = offscreenSize(display);
    gpu::OffscreenPanel panel(size.width, size.height, false);
    drawPattern(pattern, display, size.width, size.height, panel.framebuffer());
    writePicturePng(options.output,
                    gpu::readFramebuffer(panel.framebuffer(), size.width, size.height));
    return EXIT_SUCCESS;
}

} // namespace autostereo::daemon
