#pragma once

#include "calib/display_profile.hpp"
#include "gpu/gl/program.hpp"
#include "gpu/layer_drawer.hpp"
#include "gpu/params.hpp"
#include "gpu/views/atlas_views.hpp"

namespace autostereo::gpu {

/// All views in one instanced draw per layer: the view is the instance, cut to its tile by four
/// clip distances.
class InstancedViews final : public AtlasViews {
  public:
    /// Throws GlError.
    InstancedViews(const calib::DisplayProfile& display, const PipelineParams& params);
    void render(const MeshLayers& layers, const gl::Texture& color, const Atlas& atlas) override;

  private:
    PipelineParams params_;
    LayerDrawer drawer_;
    gl::Program program_;
    gl::Texture positions_;
};

} // namespace autostereo::gpu
