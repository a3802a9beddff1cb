#pragma once

#include "gpu/layer_drawer.hpp"
#include "gpu/params.hpp"
#include "gpu/pipeline.hpp"
#include "gpu/readback.hpp"

#include <cstdint>
#include <vector>

namespace autostereo::gpu {

/// Pictures of the same mesh that are no panel, for `render`; offline, they wait for the GPU.
/// All take a pipeline that has rendered a frame. Throw GlError.

/// What an eye at `eye` (display space: metres from the panel's centre, x right, y up, z toward
/// the viewer) sees in the panel's frame, at width x height pixels.
[[nodiscard]] RgbImage renderEye(const Pipeline& pipeline, const PipelineParams& params,
                                 const calib::DisplayProfile& display, glm::dvec3 eye, int width,
                                 int height);

/// The colour camera's own picture, moved by `offset` metres along its axes; fused anew in its
/// frame.
[[nodiscard]] RgbImage renderMovedCamera(const Pipeline& pipeline, const PipelineParams& params,
                                         const calib::SensorRig& rig, glm::dvec3 offset);

/// Measured depth at the colour camera: millimetres (rounded; 0: none), its size, top row first.
struct DepthImage {
    int width = 0;
    int height = 0;
    std::vector<std::uint16_t> millimetres;
};
[[nodiscard]] DepthImage renderRegisteredDepth(const gl::Texture& counts, double depthUnitM,
                                               const PipelineParams& params,
                                               const calib::SensorRig& rig);

} // namespace autostereo::gpu
