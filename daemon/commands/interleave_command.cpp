#include "daemon/commands/commands.hpp"
#include "daemon/log.hpp"
#include "daemon/picture_files.hpp"
#include "daemon/quilt_file.hpp"
#include "daemon/wiring.hpp"
#include "gpu/offscreen_panel.hpp"

namespace autostereo::daemon {

int interleave(const InterleaveOptions& options) {
    setUpLog("info");
    // What the command line and the display say comes before a picture of some hundred megabytes.
    const calib::DisplayProfile named = config::loadDisplay(options.display);
    const Quilt quilt =
        readQuilt(options.quilt, {options.columns, options.rows, options.aspect, options.views});
    const calib::DisplayProfile display = displayFor(quilt, named);
    warnOfPlaceholder(display);

    const PanelSize size = offscreenSize(display);
    gpu::OffscreenPanel panel(size.width, size.height, false);
    drawQuilt(quilt, display, size.width, size.height, {options.filter, options.texels},
              panel.framebuffer());
    writePicturePng(options.output,
                    gpu::readFramebuffer(panel.framebuffer(), size.width, size.height));
    return EXIT_SUCCESS;
}

} // namespace autostereo::daemon
