#pragma once

#include "gpu/pipeline.hpp"
#include "gpu/readback.hpp"

namespace autostereo::bench {

/// The panel that the last frame should have given, every sub-pixel searched in double precision on
/// the CPU (seconds to minutes). Throws std::invalid_argument for displays that are filled with
/// whole views.
[[nodiscard]] gpu::RgbImage referencePanel(const gpu::Pipeline& pipeline,
                                           const calib::SensorRig& rig,
                                           const calib::DisplayProfile& display, int width,
                                           int height, gpu::ViewPositions positions);

} // namespace autostereo::bench
