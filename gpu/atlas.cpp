#include "gpu/atlas.hpp"

#include "gpu/gl/error.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace autostereo::gpu {

namespace {

const AtlasLayout& allowed(const AtlasLayout& layout) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    if (layout.width() > largest || layout.height() > largest)
        throw GlError("gl: an atlas of " + std::to_string(layout.width()) + "x" +
                      std::to_string(layout.height()) +
                      " pixels is larger than the driver allows (" + std::to_string(largest) +
                      "): make the display's tiles smaller");
    return layout;
}

} // namespace

AtlasLayout atlasLayout(const calib::DisplayProfile& display, int panelWidth, int panelHeight) {
    AtlasLayout layout{display.views, display.quilt};
    if (layout.quilt.tileWidth == 0) {
        layout.quilt.tileWidth = panelWidth;
        layout.quilt.tileHeight = panelHeight;
    }
    return layout;
}

AtlasLayout scaled(AtlasLayout layout, double scale) {
    for (int* side : {&layout.quilt.tileWidth, &layout.quilt.tileHeight})
        *side = std::max(1, static_cast<int>(std::lround(scale * *side)));
    return layout;
}

Atlas::Atlas(const AtlasLayout& layout)
    : layout_(allowed(layout)), color_(GL_RGBA8, layout.width(), layout.height()),
      depth_(GL_DEPTH_COMPONENT32F, layout.width(), layout.height()),
      framebuffer_(gl::makeFramebuffer(color_, &depth_)) {}

} // namespace autostereo::gpu
