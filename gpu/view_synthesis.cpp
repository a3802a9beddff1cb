#include "gpu/view_synthesis.hpp"

#include "calib/view_map.hpp"
#include "gpu/instanced_views.hpp"
#include "gpu/multipass_views.hpp"

#include <array>
#include <vector>

namespace autostereo::gpu {

std::unique_ptr<ViewSynthesis> makeViewSynthesis(Method method,
                                                 const calib::DisplayProfile& display,
                                                 const PipelineParams& params) {
    if (method == Method::Multipass) return std::make_unique<MultipassViews>(display, params);
    return std::make_unique<InstancedViews>(display, params);
}

gl::Texture makeViewPositions(const calib::DisplayProfile& display) {
    std::vector<float> positions;
    for (int view = 0; view < display.views; ++view)
        positions.push_back(static_cast<float>(calib::viewPosition(display, view)));
    gl::Texture texture(GL_R32F, display.views, 1);
    glTextureSubImage2D(texture.name(), 0, 0, 0, display.views, 1, GL_RED, GL_FLOAT,
                        positions.data());
    return texture;
}

void clearTarget(GLuint framebuffer, const PipelineParams& params) {
    const auto& [red, green, blue] = params.clearColor;
    const std::array<float, 4> color{static_cast<float>(red), static_cast<float>(green),
                                     static_cast<float>(blue), 1.0F};
    const float farthest = 1.0F;
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glClearNamedFramebufferfv(framebuffer, GL_COLOR, 0, color.data());
    glClearNamedFramebufferfv(framebuffer, GL_DEPTH, 0, &farthest);
}

} // namespace autostereo::gpu
