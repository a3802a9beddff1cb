#pragma once

#include "gpu/interleaver.hpp"
#include "gpu/readback.hpp"
#include "gpu/scene/scene_reprojection.hpp"
#include "gpu/scene/scene_tiles.hpp"
#include "gpu/scene/scene_views.hpp"

#include <memory>
#include <optional>

namespace autostereo::gpu {

/// A scene of triangles -> the panel: placed in front of the viewer and turned, drawn into the
/// views' tiles, interleaved as camera pictures are; or (direct) every sub-pixel finds and lights
/// what its eye sees in a few reference viewpoints. Owns its passes; the caller owns the context
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

    /// The views, which every method but direct has.
    [[nodiscard]] const Atlas& atlas() const { return atlas_.value(); }
    /// The method in use: sceneMethod of the one that was asked for.
    [[nodiscard]] Method method() const { return method_; }
    /// What hybrid and direct work from; none with other methods.
    [[nodiscard]] const std::optional<SceneSurfaces>& surfaces() const { return surfaces_; }
    [[nodiscard]] const std::optional<SceneReprojection>& reprojection() const {
        return reprojection_;
    }
    [[nodiscard]] const SceneModel& model() const { return model_; }
    [[nodiscard]] const ScenePlacement& placement() const { return placement_; }

  private:
    void makeMethod(int panelWidth, int panelHeight);
    void drawDisparity();
    [[nodiscard]] SearchParams prepareSearch(const calib::PanelMap& map, int width, int height);
    void bindSearch(GLuint panel);

    const devices::mesh::MeshScene& scene_;
    SceneParams look_;
    PipelineParams params_;
    calib::DisplayProfile display_;
    ScenePlacement placement_;
    SceneBlock block_;
    SceneModel model_;
    Method method_;
    std::optional<SceneViews> views_;
    std::optional<SceneSurfaces> surfaces_;
    std::optional<SceneReprojection> reprojection_; ///< hybrid
    gl::Texture positions_;                         ///< direct
    std::optional<SceneTiles> tiles_;               ///< direct, before black
    std::optional<Atlas> atlas_;
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

/// How a scene of so many triangles is drawn for which `wanted` is asked: so, but as instanced for
/// light at vertices, which hybrid and direct cannot put off, and for direct on displays that make
/// their views themselves. Auto: direct from 1.5 million triangles times views on (below, drawing
/// every view is quicker: gpu/README), else instanced.
[[nodiscard]] Method sceneMethod(Method wanted, SceneShading shading,
                                 const calib::DisplayProfile& display, std::size_t triangles);

} // namespace autostereo::gpu
