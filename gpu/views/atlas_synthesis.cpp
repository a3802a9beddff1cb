#include "gpu/views/atlas_synthesis.hpp"

#include "gpu/views/geometry_views.hpp"
#include "gpu/views/hybrid_views.hpp"
#include "gpu/views/instanced_views.hpp"
#include "gpu/views/layered_views.hpp"
#include "gpu/views/multipass_views.hpp"

namespace autostereo::gpu {

namespace {

std::unique_ptr<AtlasViews> makeViews(const PipelineParams& params,
                                      const calib::DisplayProfile& display) {
    const SynthesisParams& synthesis = params.synthesis;
    switch (synthesis.method) {
    case Method::Multipass:
        return std::make_unique<MultipassViews>(display, params);
    case Method::Geometry:
        return std::make_unique<GeometryViews>(display, params, synthesis.viewsPerPass);
    case Method::Layered:
        return std::make_unique<LayeredViews>(display, params, synthesis.viewsPerPass);
    case Method::Hybrid:
        return std::make_unique<HybridViews>(display, params, synthesis.references);
    default:
        return std::make_unique<InstancedViews>(display, params);
    }
}

std::optional<DisparityView> disparityView(const PipelineParams& params,
                                           const calib::DisplayProfile& display,
                                           const calib::QuiltLayout& tiles) {
    if (!std::holds_alternative<calib::DepthFrame>(display.law)) return std::nullopt;
    return std::make_optional<DisparityView>(params.mesh, tiles.tileWidth, tiles.tileHeight,
                                             display.disparityFar);
}

} // namespace

AtlasSynthesis::AtlasSynthesis(const PipelineParams& params, const calib::DisplayProfile& display,
                               int panelWidth, int panelHeight)
    : atlas_(scaled(atlasLayout(display, panelWidth, panelHeight), params.synthesis.tileScale)),
      views_(makeViews(params, display)),
      disparity_(disparityView(params, display, atlas_.layout().quilt)),
      interleaver_(makeInterleaver(
          calib::panelMap(display, panelWidth, panelHeight), panelWidth, panelHeight,
          {params.synthesis.filter, params.synthesis.views, display.fringe, {}})) {}

void AtlasSynthesis::prepare(const CyclopeanScene& scene) {
    const MeshLayers& layers = mesher_.build(scene);
    views_->render(layers, scene.color, atlas_);
    if (disparity_) disparity_->render(layers, scene.color);
}

void AtlasSynthesis::show(const CyclopeanScene& /*scene*/, GLuint panel) {
    interleaver_->render({&atlas_, disparity_ ? &disparity_->texture() : nullptr}, panel);
}

} // namespace autostereo::gpu
