#pragma once

#include "calib/sensor_rig.hpp"
#include "gpu/blocks.hpp"
#include "gpu/gl/uniform_buffer.hpp"
#include "gpu/params.hpp"
#include "gpu/registered_depth.hpp"

namespace autostereo::gpu {

/// Depth counts -> depth at the colour camera at any size (de Sorbier 2010, section II.C), with
/// both cameras' distortion and occlusion as the colour camera sees it. Everything measured is
/// kept: where triangles are cut, and along the picture's border, each pixel stands for its square.
/// Beyond that, borders may be extruded: see RegistrationParams. Thread-bound.
class DepthRegistration {
  public:
    /// Throws GlError.
    DepthRegistration(const DepthMeshParams& mesh, const RegistrationParams& params,
                      const calib::SensorRig& rig);

    /// `depth`: R16UI counts of `depthUnitM`; `width` x `height`: size of the result, which covers
    /// the colour camera's whole picture.
    void render(const gl::Texture& depth, double depthUnitM, int width, int height);

    /// R32F, metres along the colour camera's axis, 0: none; top row first.
    [[nodiscard]] const gl::Texture& metres() const { return registered_.metres(); }

  private:
    /// Pixels around the picture that were not measured: its border is a cut like any other.
    [[nodiscard]] int frame() const { return params_.extrudePx + 1; }
    void resize(int width, int height);

    DepthMeshParams mesh_;
    RegistrationParams params_;
    calib::SensorRig rig_;
    MeshBlock block_;
    gl::UniformBuffer<MeshBlock> uniforms_;
    gl::Program buildPlaces_, drawMesh_, drawCuts_;
    RegisteredDepth registered_;
    gl::Texture counts_, rays_, places_; ///< frame included
    gl::Buffer cuts_;                    ///< shaders/cut_triangles.glsl
};

} // namespace autostereo::gpu
