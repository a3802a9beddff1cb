#pragma once

#include "calib/display_profile.hpp"
#include "gpu/gl/program.hpp"
#include "gpu/layer_drawer.hpp"
#include "gpu/params.hpp"
#include "gpu/views/atlas_views.hpp"

namespace autostereo::gpu {

/// The geometry shader repeats every triangle for several views at once, into one tiled atlas with
/// one depth buffer (de Sorbier 2010); as many passes as the driver's limits on its output ask for
/// (de Sorbier 2008, table 3).
class GeometryViews final : public AtlasViews {
  public:
    /// `viewsPerPass`: 0: as many as the driver allows. Throws GlError.
    GeometryViews(const calib::DisplayProfile& display, const PipelineParams& params,
                  int viewsPerPass);
    void render(const MeshLayers& layers, const gl::Texture& color, const Atlas& atlas) override;

    /// How many of `views` a pass repeats: as many as `wanted` (0: all), within the driver's limits
    /// on a geometry shader whose vertices have so many components.
    [[nodiscard]] static int allowed(int wanted, int views, int componentsPerVertex);

  private:
    PipelineParams params_;
    int viewsPerPass_;
    LayerDrawer drawer_;
    gl::Program program_;
    gl::Texture positions_;
};

} // namespace autostereo::gpu
