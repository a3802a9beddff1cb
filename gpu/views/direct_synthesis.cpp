#include "gpu/views/direct_synthesis.hpp"

#include "calib/panel_map.hpp"

namespace autostereo::gpu {

DirectSynthesis::DirectSynthesis(const PipelineParams& params, const calib::DisplayProfile& display,
                                 int panelWidth, int panelHeight)
    : skips_(params.skipUnchanged), positions_(makeViewPositions(display)) {
    const calib::PanelMap map = calib::panelMap(display, panelWidth, panelHeight);
    SearchParams search = searchParams(display, map, params.synthesis.positions);
    const auto* views = std::get_if<calib::ViewMap>(&map);
    search.rootsOnly = params.synthesis.keepRoots && views != nullptr;
    if (search.rootsOnly)
        kept_.emplace(panelWidth, panelHeight, search, views->upsideDown, display.fringe);
    interleaver_ =
        makeInterleaver(map, panelWidth, panelHeight,
                        {TileFilter::Linear, ViewFilter::Nearest, display.fringe, search});
}

void DirectSynthesis::prepare(const CyclopeanScene& scene) {
    search_.build(scene);
    if (!skips_) search_.markAll();
    ++prepared_;
}

void DirectSynthesis::show(const CyclopeanScene& scene, GLuint panel) {
    if (kept_) {
        const bool isKnown = skips_ && scene.changes != nullptr && prepared_ <= 1;
        kept_->findStale(search_, isKnown ? &scene.changes->color : nullptr);
        prepared_ = 0;
    }
    search_.bind();
    glBindTextureUnit(11, scene.color.name());
    glBindTextureUnit(12, scene.backgroundColor.name());
    glBindTextureUnit(10, positions_.name());
    interleaver_->render({}, kept_ ? kept_->target() : panel);
    if (!kept_) return;
    kept_->show(panel);
    search_.forgetChanges();
}

std::optional<KeptShare> DirectSynthesis::keptShare() const {
    return kept_ ? kept_->keptShare() : std::nullopt;
}

} // namespace autostereo::gpu
