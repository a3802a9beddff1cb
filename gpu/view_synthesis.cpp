#include "gpu/view_synthesis.hpp"

#include "calib/view_map.hpp"
#include "gpu/instanced_views.hpp"
#include "gpu/multipass_views.hpp"

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
    positions.reserve(static_cast<std::size_t>(display.views));
    for (int view = 0; view < display.views; ++view)
        positions.push_back(static_cast<float>(calib::viewPosition(display, view)));
    gl::Texture texture(GL_R32F, display.views, 1);
    glTextureSubImage2D(texture.name(), 0, 0, 0, display.views, 1, GL_RED, GL_FLOAT,
                        positions.data());
    return texture;
}

} // namespace autostereo::gpu
