#pragma once

#include "calib/display_profile.hpp"
#include "gpu/gl/program.hpp"
#include "gpu/layer_drawer.hpp"
#include "gpu/params.hpp"
#include "gpu/views/atlas_views.hpp"

namespace autostereo::gpu {

/// Every view a render target of its own (method "mrt", de Sorbier 2008): layers of one
/// framebuffer, each with the depth test of its own that the paper had to wait for, filled by the
/// geometry shader; then copied into the atlas.
class LayeredViews final : public AtlasViews {
  public:
    /// `viewsPerPass`: 0: as many as the driver allows. Throws GlError.
    LayeredViews(const calib::DisplayProfile& display, const PipelineParams& params,
                 int viewsPerPass);
    void render(const MeshLayers& layers, const gl::Texture& color, const Atlas& atlas) override;

  private:
    void resize(const AtlasLayout& layout);

    PipelineParams params_;
    int viewsPerPass_;
    LayerDrawer drawer_;
    gl::Program program_;
    gl::Texture positions_;
    gl::Texture colors_, depths_; ///< a layer a view
    gl::Framebuffer framebuffer_;
};

} // namespace autostereo::gpu
