#include "gpu/offscreen_panel.hpp"

#include "gpu/gl/lost_context.hpp"

#include <cmath>

namespace autostereo::gpu {

OffscreenPanel::OffscreenPanel(int width, int height, bool debugContext, double refreshHz)
    : context_(debugContext), color_(GL_RGBA8, width, height),
      framebuffer_(gl::makeFramebuffer(color_)),
      refresh_(refreshHz > 0 ? std::llround(1e9 / refreshHz) : 0) {}

// A window's swap bounds how far the CPU runs ahead of the GPU; here the wait does it.
void OffscreenPanel::present() {
    glFinish();
    gl::throwIfReset();
    if (refresh_.count() == 0) return;
    const devices::Duration now = clock_.now().time_since_epoch();
    clock_.sleepUntil(devices::TimePoint((now / refresh_ + 1) * refresh_));
}

} // namespace autostereo::gpu
