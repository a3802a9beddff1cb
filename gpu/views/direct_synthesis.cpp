#include "gpu/views/direct_synthesis.hpp"

#include "calib/optics.hpp"
#include "calib/panel_map.hpp"

namespace autostereo::gpu {

namespace {

/// From red to green to blue, panel widths; where the display is no lens sheet they count as one
/// place.
double channelStep(const calib::DisplayProfile& display) {
    const auto optics = calib::displayOptics(display);
    if (!optics || optics->subpixels.offsetsM.empty()) return 0;
    const auto& [red, green, blue] = optics->subpixels.offsetsM.front();
    return (blue.x - red.x) / 2 / display.widthM;
}

SearchParams searchParams(const calib::DisplayProfile& display, const calib::PanelMap& map,
                          const SynthesisParams& params) {
    SearchParams search;
    search.views = display.views;
    search.channelStep = channelStep(display);
    const auto* views = std::get_if<calib::ViewMap>(&map);
    // Sub-pixels that the maker gave to views one by one show those.
    if (views == nullptr || !views->remap.empty() || params.positions == ViewPositions::OfViews)
        return search;
    search.continuous = display.views > 1;
    const double first = calib::viewPosition(display, 0);
    const double step = calib::viewPosition(display, 1) - first;
    search.positionPerCycle = step * display.views;
    search.firstPosition = first - step / 2;
    if (views->reversed) {
        search.firstPosition += search.positionPerCycle;
        search.positionPerCycle = -search.positionPerCycle;
    }
    return search;
}

std::unique_ptr<Interleaver> interleaver(const PipelineParams& params,
                                         const calib::DisplayProfile& display, int width,
                                         int height) {
    const calib::PanelMap map = calib::panelMap(display, width, height);
    return makeInterleaver(map, width, height,
                           {TileFilter::Linear, ViewFilter::Nearest, display.fringe,
                            searchParams(display, map, params.synthesis)});
}

} // namespace

DirectSynthesis::DirectSynthesis(const PipelineParams& params, const calib::DisplayProfile& display,
                                 int panelWidth, int panelHeight)
    : positions_(makeViewPositions(display)),
      interleaver_(interleaver(params, display, panelWidth, panelHeight)) {}

void DirectSynthesis::prepare(const CyclopeanScene& scene) { search_.build(scene); }

void DirectSynthesis::show(const CyclopeanScene& scene, GLuint panel) {
    search_.bind();
    glBindTextureUnit(11, scene.color.name());
    glBindTextureUnit(12, scene.backgroundColor.name());
    glBindTextureUnit(10, positions_.name());
    interleaver_->render({}, panel);
}

} // namespace autostereo::gpu
