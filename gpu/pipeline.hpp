#pragma once

#include "calib/display_profile.hpp"
#include "devices/frame.hpp"
#include "gpu/depth_mesh.hpp"
#include "gpu/disparity_view.hpp"
#include "gpu/frame_uploader.hpp"
#include "gpu/gl/timer.hpp"
#include "gpu/interleaver.hpp"
#include "gpu/view_synthesis.hpp"

#include <array>
#include <functional>
#include <memory>
#include <optional>

namespace autostereo::gpu {

/// The GPU's stages in their order, each a pass of its own: upload, mesh, views, interleave.
/// Owns the passes; the caller owns the context. Thread-bound.
class Pipeline {
  public:
    static constexpr std::array<const char*, 4> kStages{"upload", "mesh", "views", "interleave"};
    /// Receives (index into kStages, GPU milliseconds) as results arrive, some frames late.
    using StageTime = std::function<void(std::size_t stage, double milliseconds)>;

    /// Throws GlError.
    Pipeline(const PipelineParams& params, const calib::SensorRig& rig,
             const calib::DisplayProfile& display, int panelWidth, int panelHeight);

    /// Draws one pair of frames into the panel's framebuffer.
    void render(const devices::RgbdFrame& frame, GLuint panel);
    /// Up to the atlas only.
    void renderAtlas(const devices::RgbdFrame& frame);
    void onStageTime(StageTime receiver) { stageTime_ = std::move(receiver); }

    [[nodiscard]] const Atlas& atlas() const { return atlas_; }
    [[nodiscard]] const DepthMesh& mesh() const { return mesh_; }
    /// What a display of type 2d_plus_depth gets beside the picture; none on others.
    [[nodiscard]] const std::optional<DisparityView>& disparity() const { return disparity_; }
    [[nodiscard]] const gl::Texture& color() const { return uploader_.color(); }
    /// R16UI counts as they came.
    [[nodiscard]] const gl::Texture& depth() const { return uploader_.depth(); }
    /// Set by the first frame with a measurement (or by params.budget.focusM), then kept, so that
    /// the scene stands still behind the glass.
    [[nodiscard]] const SceneGeometry& geometry() const { return geometry_; }

  private:
    void placeScene(const devices::Frame& depth);
    template<class Pass>
    void timed(std::size_t stage, Pass pass);

    PipelineParams params_;
    calib::SensorRig rig_;
    calib::DisplayProfile display_;
    double panelAspect_;
    bool placed_ = false;
    SceneGeometry geometry_;

    FrameUploader uploader_;
    DepthMesh mesh_;
    Atlas atlas_;
    std::unique_ptr<ViewSynthesis> views_;
    std::optional<DisparityView> disparity_; ///< for displays that make their views themselves
    std::unique_ptr<Interleaver> interleaver_;
    std::array<gl::Timer, kStages.size()> timers_;
    StageTime stageTime_;
};

} // namespace autostereo::gpu
