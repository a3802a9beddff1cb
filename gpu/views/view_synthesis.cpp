#include "gpu/views/view_synthesis.hpp"

#include "calib/view_map.hpp"
#include "gpu/views/atlas_synthesis.hpp"
#include "gpu/views/direct_synthesis.hpp"
#include "gpu/views/eye_synthesis.hpp"

#include <vector>

namespace autostereo::gpu {

std::unique_ptr<ViewSynthesis> makeViewSynthesis(const PipelineParams& params,
                                                 const calib::DisplayProfile& display,
                                                 int panelWidth, int panelHeight) {
    if (params.synthesis.followEyes && EyeSynthesis::fits(display))
        return std::make_unique<EyeSynthesis>(params, display, panelWidth, panelHeight);
    const bool makesViews = std::holds_alternative<calib::DepthFrame>(display.law);
    if (params.synthesis.method == Method::Direct && !makesViews)
        return std::make_unique<DirectSynthesis>(params, display, panelWidth, panelHeight);
    return std::make_unique<AtlasSynthesis>(params, display, panelWidth, panelHeight);
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
