#pragma once

#include "gpu/interleaver.hpp"
#include "gpu/readback.hpp"
#include "gpu/scene/scene_views.hpp"

#include <memory>
#include <optional>

namespace autostereo::gpu {

/// A scene of triangles -> the panel: placed in front of the viewer and turned, drawn into the
/// views' tiles, interleaved as camera pictures are. Owns its passes; the caller owns the context
/// and keeps the scene. Thread-bound.
class ScenePipeline {
  public:
    /// Of `params` synthesis and clearColor are used. Throws GlError.
    ScenePipeline(const devices::mesh::MeshScene& scene, const SceneParams& look,
                  const PipelineParams& params, const calib::DisplayProfile& display,
                  int panelWidth, int panelHeight);

    /// Draws all views as the scene is at a time.
    void prepare(double seconds);
    /// Fills the panel with what was prepared last.
    void show(GLuint panel);
    /// What an eye in display space sees of what was prepared, on the panel's own pixels.
    [[nodiscard]] RgbImage renderEye(const glm::dvec3& eye, int width, int height);

    [[nodiscard]] const Atlas& atlas() const { return atlas_; }
    /// The method in use.
    [[nodiscard]] Method method() const { return views_.method(); }
    [[nodiscard]] const ScenePlacement& placement() const { return placement_; }

  private:
    void drawDisparity();

    const devices::mesh::MeshScene& scene_;
    SceneParams look_;
    PipelineParams params_;
    calib::DisplayProfile display_;
    ScenePlacement placement_;
    SceneBlock block_;
    SceneModel model_;
    SceneViews views_;
    Atlas atlas_;
    /// For displays that make their views themselves: R32F, panel widths.
    struct Disparity {
        Disparity(int width, int height);
        gl::Program program;
        gl::Texture texture, depth, eye;
        gl::Framebuffer framebuffer;
    };
    std::optional<Disparity> disparity_;
    gl::UniformBuffer<SceneBlock> uniforms_;
    std::unique_ptr<Interleaver> interleaver_;
};

} // namespace autostereo::gpu
