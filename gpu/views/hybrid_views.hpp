#pragma once

#include "calib/display_profile.hpp"
#include "gpu/gl/program.hpp"
#include "gpu/layer_drawer.hpp"
#include "gpu/params.hpp"
#include "gpu/views/atlas_views.hpp"

namespace autostereo::gpu {

/// shaders/hybrid_views.frag, binding 3.
struct HybridBlock {
    glm::ivec4 tiles{0};
    glm::vec4 references{0};
};

/// A few reference views are drawn, all others reprojected from them (the super-multi-view paper's
/// hybrid, as it is for pictures without lights).
class HybridViews final : public AtlasViews {
  public:
    /// `references`: 2 to 5. Throws GlError.
    HybridViews(const calib::DisplayProfile& display, const PipelineParams& params, int references);
    void render(const MeshLayers& layers, const gl::Texture& color, const Atlas& atlas) override;

  private:
    void resize(const calib::QuiltLayout& tiles);
    void drawReferences(const MeshLayers& layers, const gl::Texture& color);

    PipelineParams params_;
    double farthest_; ///< panel widths
    int references_;
    LayerDrawer drawer_;
    gl::Program draw_, reproject_;
    gl::Texture referencePositions_, positions_;
    gl::Texture colors_, disparities_, depth_;
    gl::Framebuffer framebuffer_;
    gl::VertexArray vertexArray_;
    HybridBlock block_;
    gl::UniformBuffer<HybridBlock> uniforms_;
};

} // namespace autostereo::gpu
