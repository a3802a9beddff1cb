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

/// The colour camera's own picture, moved by `offset` metres along its axes; fused in its frame.
class MovedCamera {
  public:
    MovedCamera(const PipelineParams& params, const calib::SensorRig& rig, glm::dvec3 offset);
    /// Frame by frame: what an earlier one saw is remembered.
    [[nodiscard]] RgbImage render(const Pipeline& pipeline);

  private:
    PipelineParams params_;
    calib::SensorRig rig_;
    glm::dvec3 offset_;
    SceneGeometry geometry_;
    DepthMesh mesh_;
    Fusion fusion_;
    gl::Program program_;
};

/// 32-bit floats, tightly packed, top row first.
struct FloatImage {
    int width = 0;
    int height = 0;
    std::vector<float> values;
};
/// Disparity of the cyclopean view, panel widths at the edge of the fan (near: > 0), inside the
/// display's budget, at width x height pixels.
[[nodiscard]] FloatImage renderDisparity(const Pipeline& pipeline, const PipelineParams& params,
                                         const calib::DisplayProfile& display, int width,
                                         int height);

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
