#pragma once

#include "config/config.hpp"
#include "daemon/session/idle.hpp"
#include "daemon/session/method_memory.hpp"
#include "daemon/session/pattern_picture.hpp"
#include "daemon/session/preview.hpp"
#include "daemon/session/report.hpp"
#include "daemon/wiring.hpp"
#include "gpu/dimmer.hpp"
#include "gpu/pipeline.hpp"
#include "gpu/readback.hpp"
#include "gpu/scene/scene_pipeline.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace autostereo::daemon {

/// The panel and everything that fills it: live pictures through the pipeline, messages, test
/// patterns. Thread-bound.
class Screen {
  public:
    /// Throws ConfigError, GlError.
    Screen(const config::Config& config, config::Output output, bool force);

    /// Cameras are known: from here on frames can be shown. Throws GlError.
    void start(const calib::SensorRig& rig);
    /// In place of cameras; the scene has to outlive this. Throws GlError.
    void start(const devices::mesh::MeshScene& scene);
    /// Other depth, method or brightness, from the next picture on. Throws GlError.
    void adjust(const config::Config& config);
    /// Another configuration altogether; frames go on coming from the same cameras. Throws
    /// ConfigError and changes nothing where the panel would have to be another.
    void replace(const config::Config& config);
    /// Everything in the panel's plane, as long as nothing knows how far away it is.
    void setFlat(bool flat);

    void show(const devices::RgbdFrame& frame);
    /// Waits until the GPU has filled the panel: no picture is begun behind one that is unfinished.
    void finish();
    /// The scene as it is at a time. After `start` with one.
    void showScene(double seconds);
    /// The last frame again, as the viewer's eyes see it now. After `show`.
    void showAgain();
    /// Where the viewer's eyes are, asked just before the panel is filled; from the next picture
    /// on.
    void followEyes(std::function<calib::EyePair()> latch) { latch_ = std::move(latch); }
    /// An idle picture with a message; without one, the idle content as it is at a time.
    void showIdle(const std::string& text, double seconds);
    /// Whether that content looks otherwise now than when it was shown last.
    [[nodiscard]] bool advanceIdle(double seconds) { return idle_.advance(seconds); }
    /// It is not to be seen any more.
    void leaveIdle() { idle_.leave(); }
    void showBlack();
    /// Throws UsageError, GlError.
    void showPattern(const Pattern& pattern);

    /// For the operator, of the last frame; then that has to be shown anew. After `show`. Throws
    /// GlError.
    [[nodiscard]] gpu::RgbImage preview(const PreviewRequest& request);
    /// What was drawn last, as it is without presenting it.
    [[nodiscard]] gpu::RgbImage picture() const;
    [[nodiscard]] gpu::Panel& panel() { return *panel_; }
    [[nodiscard]] const calib::DisplayProfile& display() const { return chosen_.profile; }
    /// Fills in what the report says of the panel's stages.
    void account(Report& report) const;
    /// None before `start`, or before the first frame was seen.
    [[nodiscard]] gpu::Pipeline* pipeline() { return pipeline_.get(); }
    void onStageTime(gpu::Pipeline::StageTime receiver);
    /// To be called after the first picture: what Method::Auto chose is kept.
    void keepChoice() const;

  private:
    [[nodiscard]] gpu::PipelineParams params() const;
    void build();
    /// A picture that is drawn once and kept while it has the same name.
    void showStill(const std::string& name, const std::function<void(GLuint)>& draw);
    [[nodiscard]] StandingTarget standing(GLuint framebuffer) const {
        return {display(), panel_->width(), panel_->height(), framebuffer};
    }
    void applyLook();
    void dim();
    void fill();

    config::Config config_;
    config::Output output_;
    bool force_;
    bool flat_ = false;
    ChosenDisplay chosen_;
    std::unique_ptr<gpu::Panel> panel_;
    gpu::Dimmer dimmer_;
    Idle idle_;
    std::optional<calib::SensorRig> rig_;
    std::optional<MethodMemory> methods_;
    std::unique_ptr<gpu::Pipeline> pipeline_;
    std::unique_ptr<Preview> preview_;                ///< none before somebody looks
    const devices::mesh::MeshScene* scene_ = nullptr; ///< its owner's; none: cameras
    std::unique_ptr<gpu::ScenePipeline> scenePipeline_;
    gpu::Pipeline::StageTime stageTime_;
    std::function<calib::EyePair()> latch_;
    gpu::gl::Texture still_; ///< a message or a pattern, as the panel has it
    gpu::gl::Framebuffer stillFrame_;
    std::string stillName_; ///< what it shows; empty: nothing yet
};

} // namespace autostereo::daemon
