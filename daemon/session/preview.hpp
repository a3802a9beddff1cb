#pragma once

#include "calib/display_profile.hpp"
#include "daemon/http/question_box.hpp"
#include "daemon/session/coarse_scene.hpp"
#include "gpu/blocks.hpp"
#include "gpu/gl/program.hpp"
#include "gpu/gl/uniform_buffer.hpp"
#include "gpu/layer_drawer.hpp"
#include "gpu/pipeline.hpp"
#include "gpu/readback.hpp"
#include "gpu/views/disparity_view.hpp"
#include "gpu/views/layer_mesher.hpp"

namespace autostereo::daemon {

/// Small pictures for the operator of what a pipeline has prepared: colour as the camera gives it,
/// depth and an eye's view in the panel's form, at most 480 pixels a side. Keeps its programs and
/// targets, as making them costs several pictures' time. Thread-bound.
class Preview {
  public:
    /// Throws GlError.
    Preview(const gpu::PipelineParams& params, const calib::DisplayProfile& display, int panelWidth,
            int panelHeight);

    /// `pipeline` has to have shown a frame, and has to prepare one before it shows anything again.
    /// Waits for the GPU.
    [[nodiscard]] gpu::RgbImage draw(const PreviewRequest& request, const gpu::Pipeline& pipeline);

  private:
    [[nodiscard]] gpu::RgbImage drawDepth(const gpu::MeshLayers& layers,
                                          const gpu::Pipeline& pipeline);
    [[nodiscard]] gpu::RgbImage drawEye(const gpu::MeshLayers& layers,
                                        const gpu::Pipeline& pipeline, double place);

    std::array<double, 3> clearColor_;
    calib::DisplayProfile display_;
    CoarseScene coarse_;
    gpu::LayerMesher mesher_;
    gpu::LayerDrawer drawer_;
    gpu::gl::Program program_;
    gpu::gl::UniformBuffer<gpu::MeshBlock> mesh_;
    gpu::gl::UniformBuffer<gpu::EyeBlock> eye_;
    gpu::gl::Texture color_, depth_;
    gpu::gl::Framebuffer target_;
    gpu::DisparityView disparity_;
};

} // namespace autostereo::daemon
