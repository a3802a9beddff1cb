#include "gpu/views/eye_synthesis.hpp"

#include "calib/band_map.hpp"

#include <variant>
#include <vector>

namespace autostereo::gpu {

namespace {

calib::EyePair nominal(const calib::DisplayProfile& display) {
    const std::vector<glm::dvec3> eyes = calib::nominalEyes(display);
    return {eyes.front(), eyes.back()};
}

calib::BandMap bands(const calib::DisplayProfile& display, int width, int height,
                     const calib::EyePair& eyes) {
    return calib::bandMap(display, width, height, {eyes.left, eyes.right});
}

} // namespace

bool EyeSynthesis::fits(const calib::DisplayProfile& display) {
    return display.views == 2 && (std::holds_alternative<calib::LineScreen>(display.law) ||
                                  std::holds_alternative<calib::TrackedLens>(display.law));
}

EyeSynthesis::EyeSynthesis(const PipelineParams& params, const calib::DisplayProfile& display,
                           int panelWidth, int panelHeight)
    : params_(params), display_(display), panelWidth_(panelWidth), panelHeight_(panelHeight),
      eyes_(nominal(display)),
      atlas_(scaled(atlasLayout(display, panelWidth, panelHeight), params.synthesis.tileScale)),
      drawer_(params.mesh), program_({"mesh_eye.vert", "mesh_view.frag"}),
      interleaver_(bands(display, panelWidth, panelHeight, eyes_),
                   {params.synthesis.filter, ViewFilter::Nearest, display.fringe, {}}) {}

void EyeSynthesis::prepare(const CyclopeanScene& scene) { layers_ = &mesher_.build(scene); }

void EyeSynthesis::setEyes(const calib::EyePair& eyes) {
    eyes_ = eyes;
    interleaver_.update(bands(display_, panelWidth_, panelHeight_, eyes));
}

void EyeSynthesis::drawViews(const CyclopeanScene& scene) {
    const AtlasLayout& layout = atlas_.layout();
    const double aspect = static_cast<double>(panelHeight_) / panelWidth_;
    LayerDrawer::clear(atlas_.framebuffer(), params_.clearColor);
    program_.use();
    const std::array eyes{eyes_.left, eyes_.right};
    for (int view = 0; view < 2; ++view) {
        uniforms_.bind(3, eyeBlock(display_, eyes.at(static_cast<std::size_t>(view)), aspect));
        glViewport(layout.left(view), layout.bottom(view), layout.quilt.tileWidth,
                   layout.quilt.tileHeight);
        drawer_.draw(*layers_, scene.color, {1, 1, view, 0}, 1);
    }
}

void EyeSynthesis::show(const CyclopeanScene& scene, GLuint panel) {
    drawViews(scene);
    interleaver_.render({&atlas_, nullptr}, panel);
}

} // namespace autostereo::gpu
