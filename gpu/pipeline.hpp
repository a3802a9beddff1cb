#pragma once

#include "calib/display_profile.hpp"
#include "devices/frame.hpp"
#include "gpu/depth_budget.hpp"
#include "gpu/depth_conditioner.hpp"
#include "gpu/depth_mesh.hpp"
#include "gpu/frame_uploader.hpp"
#include "gpu/fusion/fusion.hpp"
#include "gpu/gl/timer.hpp"
#include "gpu/views/method_choice.hpp"

#include <array>
#include <functional>
#include <memory>

namespace autostereo::gpu {

/// The GPU's stages in their order: upload, condition, mesh, fuse, views, interleave.
/// Owns the passes; the caller owns the context. Thread-bound.
class Pipeline {
  public:
    static constexpr std::array<const char*, 6> kStages{"upload", "condition", "mesh",
                                                        "fuse",   "views",     "interleave"};
    /// Receives (index into kStages, GPU milliseconds) as results arrive, some frames late.
    using StageTime = std::function<void(std::size_t stage, double milliseconds)>;

    /// Throws GlError.
    Pipeline(const PipelineParams& params, const calib::SensorRig& rig,
             const calib::DisplayProfile& display, int panelWidth, int panelHeight);

    /// Draws one pair of frames into the panel's framebuffer.
    void render(const devices::RgbdFrame& frame, GLuint panel);
    /// All but filling the panel.
    void prepare(const devices::RgbdFrame& frame);
    /// Fills the panel with what was prepared last, anew. After `prepare`.
    void show(GLuint panel);
    /// Where the viewer's eyes are, from the next `show` on, where params.synthesis.followEyes.
    void setEyes(const calib::EyePair& eyes);
    /// Whether a frame like the last one, which came so many times in a row, would give the same
    /// picture. May wait for the GPU.
    [[nodiscard]] bool isStill(std::uint64_t times) {
        return times >= conditioner_.restsAfter() && (!budget_ || !budget_->moves(geometry_));
    }
    /// From the next frame on: what the scene's place is, and how its views come to the panel.
    /// Throws GlError.
    void adjust(const DepthBudgetParams& budget, Method method);
    void onStageTime(StageTime receiver) { stageTime_ = std::move(receiver); }

    /// None where the method draws no views.
    [[nodiscard]] const Atlas* atlas() const { return views_ ? views_->atlas() : nullptr; }
    /// The method in use; Auto before the first frame.
    [[nodiscard]] std::optional<KeptShare> keptShare() const {
        return views_ ? views_->keptShare() : std::nullopt;
    }
    /// Share of the colour camera's blocks that were taken for what they were before.
    [[nodiscard]] double keptColorShare() const {
        const ColorHold& hold = uploader_.hold();
        return hold.blocksSeen() == 0 ? 0
                                      : static_cast<double>(hold.blocksKept()) /
                                            static_cast<double>(hold.blocksSeen());
    }
    /// How the newest colour picture came.
    [[nodiscard]] devices::PixelWay colorWay() const { return uploader_.colorWay(); }
    [[nodiscard]] Method method() const { return params_.synthesis.method; }
    /// What Method::Auto chose when it saw the first frame; none with another method.
    [[nodiscard]] const std::optional<MethodChoice>& choice() const { return choice_; }
    [[nodiscard]] const DepthConditioner& conditioner() const { return conditioner_; }
    [[nodiscard]] const DepthMesh& mesh() const { return mesh_; }
    [[nodiscard]] const Fusion& fusion() const { return fusion_; }
    [[nodiscard]] CyclopeanScene scene() const { return fusion_.scene(uploader_.color()); }
    /// Conditioned counts, R16UI.
    [[nodiscard]] const gl::Texture& depth() const { return conditioner_.depth(); }
    [[nodiscard]] const gl::Texture& color() const { return uploader_.color(); }
    /// Set by the first frame with a measurement (or by params.budget.focusM), then kept, so that
    /// the scene stands still behind the glass; with params.budget.follow its law follows.
    [[nodiscard]] const SceneGeometry& geometry() const { return geometry_; }
    /// None without params.budget.follow.
    [[nodiscard]] const std::optional<DepthBudget>& budget() const { return budget_; }

  private:
    void placeScene(const devices::Frame& depth);
    void makeViews();
    void buildMesh(const devices::FrameMetadata& depth);
    template<class Pass>
    void timed(std::size_t stage, Pass pass);

    PipelineParams params_;
    calib::SensorRig rig_;
    calib::DisplayProfile display_;
    int panelWidth_, panelHeight_;
    bool placed_ = false;
    SceneGeometry geometry_;
    std::optional<DepthBudget> budget_;

    FrameUploader uploader_;
    DepthConditioner conditioner_;
    DepthMesh mesh_;
    Fusion fusion_;
    std::unique_ptr<ViewSynthesis> views_; ///< none until a method is chosen
    std::optional<MethodChoice> choice_;
    std::array<gl::Timer, kStages.size()> timers_;
    StageTime stageTime_;
    std::optional<calib::EyePair> eyes_;
};

} // namespace autostereo::gpu
