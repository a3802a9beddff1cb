#pragma once

#include "gpu/atlas.hpp"
#include "gpu/scene/scene_surfaces.hpp"

namespace autostereo::gpu {

/// All views' tiles from the reference viewpoints (the super-multi-view paper's hybrid rendering,
/// section II B and C): found in them by reprojection, holes filled between their left and right
/// ends, lit for each view's own eye. Thread-bound.
class SceneReprojection {
  public:
    /// Throws GlError.
    SceneReprojection(const calib::DisplayProfile& display, SceneShading shading);

    /// From what `surfaces` drew last, of parts that `model` placed.
    void render(SceneSurfaces& surfaces, const SceneModel& model, const SceneBlock& block,
                const Atlas& atlas);

    /// R32UI, the atlas' size: what each pixel shows (shaders/scene_root.glsl).
    [[nodiscard]] const gl::Texture& roots() const { return roots_; }

  private:
    gl::Program find_, resolve_;
    gl::Texture positions_, roots_;
    gl::Framebuffer framebuffer_;
    gl::VertexArray vertexArray_;
    gl::UniformBuffer<SceneBlock> uniforms_;
};

} // namespace autostereo::gpu
