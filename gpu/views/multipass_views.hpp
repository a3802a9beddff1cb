#pragma once

#include "calib/display_profile.hpp"
#include "gpu/gl/program.hpp"
#include "gpu/layer_drawer.hpp"
#include "gpu/params.hpp"
#include "gpu/views/atlas_views.hpp"

namespace autostereo::gpu {

/// One draw per view and layer into its own viewport: the plain way, and the check of the others.
class MultipassViews final : public AtlasViews {
  public:
    /// Throws GlError.
    MultipassViews(const calib::DisplayProfile& display, const PipelineParams& params);
    void render(const MeshLayers& layers, const gl::Texture& color, const Atlas& atlas) override;

  private:
    PipelineParams params_;
    LayerDrawer drawer_;
    gl::Program program_;
    gl::Texture positions_;
};

} // namespace autostereo::gpu
