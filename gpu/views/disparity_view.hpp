#pragma once

#include "gpu/gl/program.hpp"
#include "gpu/layer_drawer.hpp"
#include "gpu/params.hpp"

namespace autostereo::gpu {

/// The cyclopean view's disparity (R32F, panel widths at |b| = 1), for displays that make their
/// views themselves. Thread-bound.
class DisparityView {
  public:
    /// `farthest`: where nothing was measured. Throws GlError.
    DisparityView(const DepthMeshParams& params, int width, int height, double farthest);
    void render(const MeshLayers& layers, const gl::Texture& color);
    [[nodiscard]] const gl::Texture& texture() const { return disparity_; }
    [[nodiscard]] GLuint framebuffer() const { return framebuffer_.name(); }

  private:
    LayerDrawer drawer_;
    gl::Program program_;
    gl::Texture disparity_;
    gl::Texture depth_;
    gl::Framebuffer framebuffer_;
    gl::Texture position_; ///< b = 0
    double farthest_;
};

} // namespace autostereo::gpu
