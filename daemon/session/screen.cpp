#include "daemon/session/screen.hpp"

#include "calib/flat_panel.hpp"
#include "calib/message_picture.hpp"
#include "calib/panel_map.hpp"
#include "daemon/find_display.hpp"
#include "daemon/session/pattern_picture.hpp"
#include "daemon/session/scene_content.hpp"
#include "gpu/gl/usage.hpp"
#include "gpu/views/eye_synthesis.hpp"

#include <spdlog/spdlog.h>

namespace autostereo::daemon {

namespace {

std::vector<std::pair<std::string, double>> perFrame(const gpu::DepthConditioner::Tally& tally) {
    std::vector<std::pair<std::string, double>> pixels;
    for (std::size_t i = 0; i < tally.pixels.size() && tally.frames > 0; ++i)
        pixels.emplace_back(gpu::DepthConditioner::kTallies[i],
                            static_cast<double>(tally.pixels[i]) /
                                static_cast<double>(tally.frames));
    return pixels;
}

ChosenDisplay choose(const config::Config& config, config::Output output, bool force) {
    if (output == config::Output::Window) return chooseWindowDisplay(config, force);
    return {chooseDisplay(config), ""};
}

} // namespace

Screen::Screen(const config::Config& config, config::Output output, bool force)
    : config_(config), output_(output), force_(force), chosen_(choose(config, output, force)),
      panel_(openPanel(chosen_.profile, output, force, config.refreshHz, chosen_.connector)) {
    spdlog::info("display: {} ({} views), {}x{} {}", display().model, display().views,
                 panel_->width(), panel_->height(), panel_->description());
    spdlog::info("renderer: {}", gpu::rendererName());
}

gpu::PipelineParams Screen::params() const {
    gpu::PipelineParams params = pipelineParams(config_, true);
    params.synthesis.followEyes =
        !config_.viewer.source.empty() && gpu::EyeSynthesis::fits(display());
    if (flat_) {
        params.budget.depthScale = 0;
        params.budget.follow = false;
    }
    return params;
}

void Screen::start(const calib::SensorRig& rig) {
    rig_ = rig;
    build();
}

void Screen::start(const devices::mesh::MeshScene& scene) {
    scene_ = &scene;
    build();
}

void Screen::build() {
    if (scene_ != nullptr) {
        scenePipeline_.reset();
        scenePipeline_ =
            std::make_unique<gpu::ScenePipeline>(*scene_, sceneParams(config_), config_.pipeline,
                                                 display(), panel_->width(), panel_->height());
        return;
    }
    const gpu::PipelineParams wanted = params();
    methods_.emplace(DisplayPlaces::ofSystem().state, wanted, display(), panel_->width(),
                     panel_->height(), *rig_);
    preview_.reset();
    pipeline_.reset(); // never two at once: they are what fills the GPU's memory
    pipeline_ = std::make_unique<gpu::Pipeline>(methods_->apply(wanted), *rig_, display(),
                                                panel_->width(), panel_->height());
    pipeline_->onStageTime(stageTime_);
}

void Screen::adjust(const config::Config& config) {
    config_ = config;
    if (scene_ != nullptr) return build();
    if (!pipeline_) return;
    const gpu::PipelineParams wanted = methods_->apply(params());
    pipeline_->adjust(wanted.budget, wanted.synthesis.method);
}

void Screen::replace(const config::Config& config) {
    ChosenDisplay next = choose(config, output_, force_);
    const calib::DisplayProfile& profile = next.profile;
    const bool fits = profile.width == 0 ||
                      (profile.width == panel_->width() && profile.height == panel_->height());
    if (!fits || next.connector != chosen_.connector)
        throw config::ConfigError("display.profile: " + profile.name +
                                  " needs another panel: restart the program");
    chosen_ = std::move(next);
    config_ = config;
    stillName_.clear();
    if (rig_ || scene_ != nullptr) build();
}

void Screen::setFlat(bool flat) {
    if (flat == flat_) return;
    flat_ = flat;
    adjust(config_);
}

void Screen::show(const devices::RgbdFrame& frame) {
    pipeline_->prepare(frame);
    fill();
}

void Screen::finish() { glFinish(); }

void Screen::showScene(double seconds) {
    scenePipeline_->prepare(seconds);
    fill();
}

void Screen::showAgain() {
    if (pipeline_) fill();
}

void Screen::fill() {
    if (scenePipeline_) {
        scenePipeline_->show(panel_->framebuffer());
    } else {
        if (latch_) pipeline_->setEyes(latch_());
        pipeline_->show(panel_->framebuffer());
    }
    dim();
}

bool Screen::makeStill(const std::string& name) {
    if (stillName_ == name) return false;
    stillName_ = name;
    if (still_.isSized(panel_->width(), panel_->height())) return true;
    still_ = gpu::gl::Texture(GL_RGBA8, panel_->width(), panel_->height());
    stillFrame_ = gpu::gl::makeFramebuffer(still_);
    return true;
}

void Screen::showMessage(const std::string& text) {
    const int width = panel_->width(), height = panel_->height();
    if (makeStill("message " + text)) {
        const calib::Picture panel =
            calib::flatPanel(calib::messagePicture(config_.idle.picture, text, width, height),
                             calib::panelMap(display(), width, height), display().views);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        glTextureSubImage2D(still_.name(), 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE,
                            panel.pixels.data());
    }
    // The picture's top row lies first in the texture, GL's rows go up.
    glBlitNamedFramebuffer(stillFrame_.name(), panel_->framebuffer(), 0, 0, width, height, 0,
                           height, width, 0, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    dim();
}

void Screen::showBlack() {
    constexpr std::array kBlack{0.0F, 0.0F, 0.0F, 1.0F};
    glClearNamedFramebufferfv(panel_->framebuffer(), GL_COLOR, 0, kBlack.data());
}

void Screen::showPattern(const Pattern& pattern) {
    const int width = panel_->width(), height = panel_->height();
    if (makeStill("pattern " + nameOf(pattern)))
        drawPattern(pattern, display(), width, height, stillFrame_.name());
    glBlitNamedFramebuffer(stillFrame_.name(), panel_->framebuffer(), 0, 0, width, height, 0, 0,
                           width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

/// Disparities and headers are no light.
void Screen::dim() {
    if (config_.brightness >= 1) return;
    gpu::Dimmer::Area area{0, 0, panel_->width(), panel_->height()};
    if (const auto* frame = std::get_if<calib::DepthFrame>(&display().law)) {
        area.width /= 2;
        if (frame->header) --area.height;
    }
    dimmer_.dim(panel_->framebuffer(), area, config_.brightness);
}

gpu::RgbImage Screen::preview(const PreviewRequest& request) {
    if (!preview_)
        preview_ =
            std::make_unique<Preview>(params(), display(), panel_->width(), panel_->height());
    return preview_->draw(request, *pipeline_);
}

gpu::RgbImage Screen::picture() const {
    return gpu::readFramebuffer(panel_->framebuffer(), panel_->width(), panel_->height());
}

void Screen::account(Report& report) const {
    const gpu::gl::Usage gpu = gpu::gl::usage();
    report.gpuMemoryMib = static_cast<double>(gpu.bytes) / (1024 * 1024);
    report.gpuObjects = gpu.objects;
    report.display = display().name;
    report.renderer = gpu::rendererName();
    if (scenePipeline_) report.method = gpu::methodName(scenePipeline_->method());
    if (!pipeline_) return;
    report.conditioner = perFrame(pipeline_->conditioner().tally());
    report.keptColor = pipeline_->keptColorShare();
    report.keptFusion = pipeline_->fusion().holes().keptShare();
    if (const auto kept = pipeline_->keptShare()) {
        report.keptShare = kept->search;
        report.keptPicture = kept->picture;
    }
    report.method = gpu::methodName(pipeline_->method());
    if (report.presented == 0) return;
    const gpu::SceneGeometry& geometry = pipeline_->geometry();
    report.depth = {geometry.law.focusM, gpu::relativeScale(geometry, display()), {}};
    if (pipeline_->budget()) report.depth->clampedShare = pipeline_->budget()->clampedShare();
}

void Screen::onStageTime(gpu::Pipeline::StageTime receiver) {
    stageTime_ = std::move(receiver);
    if (pipeline_) pipeline_->onStageTime(stageTime_);
}

void Screen::keepChoice() const {
    if (!pipeline_ || !pipeline_->choice()) return;
    for (const gpu::MethodTrial& trial : pipeline_->choice()->trials)
        spdlog::info("method {}: {:.1f} ms, {:.1f} dB", gpu::methodName(trial.method),
                     trial.milliseconds, trial.psnrDb);
    if (const auto problem = methods_->keep(*pipeline_->choice()))
        spdlog::warn("method: {}", *problem);
}

} // namespace autostereo::daemon
