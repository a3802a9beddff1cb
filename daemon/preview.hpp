#pragma once

#include "calib/display_profile.hpp"
#include "daemon/question_box.hpp"
#include "gpu/pipeline.hpp"
#include "gpu/readback.hpp"

namespace autostereo::daemon {

/// A picture for the operator of what a pipeline has prepared, up to 640 pixels a side where it is
/// drawn for the purpose. Takes a pipeline that has shown a frame; waits for the GPU and leaves its
/// own block at binding 0, so the pipeline has to prepare a frame before it shows anything again.
/// Throws GlError.
[[nodiscard]] gpu::RgbImage previewOf(const PreviewRequest& request, const gpu::Pipeline& pipeline,
                                      const gpu::PipelineParams& params,
                                      const calib::DisplayProfile& display, int panelWidth,
                                      int panelHeight);

} // namespace autostereo::daemon
