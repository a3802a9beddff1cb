#include "gpu/offscreen_panel.hpp"

#include "gpu/gl/lost_context.hpp"

namespace autostereo::gpu {

OffscreenPanel::OffscreenPanel(int width, int height, bool debugContext)
    : context_(debugContext), color_(GL_RGBA8, width, height),
      framebuffer_(gl::makeFramebuffer(color_)) {}

// A window's swap bounds how far the CPU runs ahead of the GPU; here the wait does it.
void OffscreenPanel::present() {
    glFinish();
    gl::throwIfReset();
}

} // namespace autostereo::gpu
