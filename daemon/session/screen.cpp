#include "daemon/session/screen.hpp"

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

constexpr const char* kContentStill = "idle";

ChosenDisplay choose(const config::Config& config, config::Output output, bool force) {
    if (output == config::Output::Window) return chooseWindowDisplay(config, force);
    return {chooseDisplay(config), ""};
}

} // namespace

Screen::Screen(const config::Config& config, config::Output output, bool force)
    : config_(config), output_(output), force_(force), chosen_(choose(config, output, force)),
      panel_(openPanel(chosen_.profile, output, force, config.refreshHz, chosen_.connector)),
      idle_(config) {
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
    idle_.replace(config);
    if (stillName_ == kContentStill) stillName_.clear(); // it may look otherwise
    applyLook();
}

void Screen::applyLook() {
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
    idle_.replace(config);
    if (rig_ || scene_ != nullptr) build();
}

void Screen::setFlat(bool flat) {
    if (flat == flat_) return;
    flat_ = flat;
    applyLook();
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

void Screen::showStill(const std::string& name, const std::function<void(GLuint)>& draw) {
    const int width = panel_->width(), height = panel_->height();
    if (!still_.isSized(width, height)) {
        still_ = gpu::gl::Texture(GL_RGBA8, width, height);
        stillFrame_ = gpu::gl::makeFramebuffer(still_);
    }
    if (stillName_ != name) {
        stillName_.clear(); // if drawing fails
        draw(stillFrame_.name());
        stillName_ = name;
    }
    glBlitNamedFramebuffer(stillFrame_.name(), panel_->framebuffer(), 0, 0, width, height, 0, 0,
                           width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void Screen::showIdle(const std::string& text, double seconds) {
    const auto draw = [&](GLuint framebuffer) { idle_.draw(text, seconds, standing(framebuffer)); };
    if (text.empty() && idle_.moves())
        draw(panel_->framebuffer());
    else
        showStill(text.empty() ? kContentStill : "message " + text, draw);
    dim();
}

void Screen::showBlack() {
    constexpr std::array kBlack{0.0F, 0.0F, 0.0F, 1.0F};
    glClearNamedFramebufferfv(panel_->framebuffer(), GL_COLOR, 0, kBlack.data());
}

void Screen::showPattern(const Pattern& pattern) {
    showStill("pattern " + nameOf(pattern), [&](GLuint framebuffer) {
        drawPattern(pattern, display(), panel_->width(), panel_->height(), framebuffer);
    });
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
    report.colorWay = devices::pixelWayName(pipeline_->colorWay());
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
