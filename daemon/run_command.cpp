#include "daemon/commands.hpp"
#include "daemon/find_display.hpp"
#include "daemon/log.hpp"
#include "daemon/method_memory.hpp"
#include "daemon/picture_files.hpp"
#include "daemon/report.hpp"
#include "daemon/stop_signal.hpp"
#include "daemon/watchdog.hpp"
#include "daemon/wiring.hpp"
#include "gpu/gl/usage.hpp"
#include "gpu/pipeline.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cstring>

namespace autostereo::daemon {

namespace {

constexpr std::uint64_t kOffscreenFrames = 120; // without --frames
constexpr const char* kOffscreenPicture = "autostereo-panel.png";
constexpr std::chrono::seconds kLogInterval{10};
constexpr std::chrono::milliseconds kFrameWait{16};

bool sameBytes(const devices::Frame& a, const devices::Frame& b) {
    const auto x = a.pixels(), y = b.pixels();
    return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size()) == 0;
}

bool measuresNothing(const devices::Frame& depth) {
    return std::ranges::all_of(depth.depth(),
                               [](std::uint16_t count) { return count == 0 || count == 0xffff; });
}

std::vector<std::pair<std::string, double>> perFrame(const gpu::DepthConditioner::Tally& tally) {
    std::vector<std::pair<std::string, double>> pixels;
    for (std::size_t i = 0; i < tally.pixels.size() && tally.frames > 0; ++i)
        pixels.emplace_back(gpu::DepthConditioner::kTallies[i],
                            static_cast<double>(tally.pixels[i]) /
                                static_cast<double>(tally.frames));
    return pixels;
}

/// One run: frames from the feed through the pipeline to the panel, and the accounts of it.
class Session {
  public:
    Session(const RunOptions& options, const config::Config& config)
        : output_(options.output.value_or(chooseOutput(config))),
          realtime_(options.speed.value_or(config::Speed::Realtime) == config::Speed::Realtime),
          chosen_(output_ == config::Output::Window ? chooseWindowDisplay(config, options.force)
                                                    : ChosenDisplay{chooseDisplay(config), ""}),
          display_(chosen_.profile), input_(openScene(config)), rig_(*input_.rig),
          panel_(openPanel(display_, output_, options.force, chosen_.connector)),
          params_(pipelineParams(config, true)),
          methods_(DisplayPlaces::ofSystem().state, params_, display_, panel_->width(),
                   panel_->height(), rig_),
          pipeline_(methods_.apply(params_), rig_, display_, panel_->width(), panel_->height()) {
        report_.input = config.input;
        report_.display = display_.name;
        report_.renderer = gpu::rendererName();
        report_.stageNames.assign(gpu::Pipeline::kStages.begin(), gpu::Pipeline::kStages.end());
        report_.stageMs.resize(report_.stageNames.size());
        pipeline_.onStageTime(
            [this](std::size_t stage, double ms) { report_.stageMs[stage].add(ms); });
        spdlog::info("display: {} ({} views), {}x{} {}", display_.model, display_.views,
                     panel_->width(), panel_->height(), panel_->description());
        spdlog::info("renderer: {}", report_.renderer);
        const bool loop = output_ == config::Output::Window; // a kiosk goes on
        feed_ = openFeed(std::move(input_), config,
                         realtime_ ? config::Speed::Realtime : config::Speed::Max, loop, clock_);
        if (output_ == config::Output::Offscreen) framesWanted_ = kOffscreenFrames;
        if (options.frames) framesWanted_ = *options.frames;
    }

    void loop(const StopSignal& stop) {
        Watchdog watchdog;
        started_ = clock_.now();
        auto logAt = started_ + kLogInterval;
        watchdog.ready();
        while (!stop.requested() && !panel_->closed() && !finished()) {
            if (auto frame = feed_->next(kFrameWait)) show(std::move(*frame));
            panel_->pollEvents();
            watchdog.pet();
            if (clock_.now() < logAt) continue;
            logAt += kLogInterval;
            spdlog::info("{}", accounts().summary());
        }
        watchdog.stopping();
    }

    [[nodiscard]] const Report& accounts() {
        report_.feed = feed_->counters();
        report_.conditioner = perFrame(pipeline_.conditioner().tally());
        const gpu::gl::Usage gpu = gpu::gl::usage();
        report_.gpuMemoryMib = static_cast<double>(gpu.bytes) / (1024 * 1024);
        report_.gpuObjects = gpu.objects;
        if (report_.presented > 0) report_.depth = placement();
        report_.method = methodName(pipeline_.method());
        report_.seconds = std::chrono::duration<double>(clock_.now() - started_).count();
        return report_;
    }

    void writePicture(const std::filesystem::path& file) {
        writePicturePng(
            file, gpu::readFramebuffer(panel_->framebuffer(), panel_->width(), panel_->height()));
    }
    [[nodiscard]] bool endedWithoutPicture() const {
        return feed_->ended() && report_.presented == 0;
    }
    [[nodiscard]] bool offscreen() const { return output_ == config::Output::Offscreen; }

  private:
    [[nodiscard]] bool finished() const {
        return feed_->ended() ||
               (framesWanted_ && report_.presented + report_.skippedTotal() >= *framesWanted_);
    }

    [[nodiscard]] Report::Depth placement() const {
        const gpu::SceneGeometry& geometry = pipeline_.geometry();
        Report::Depth depth{geometry.law.focusM, gpu::relativeScale(geometry, display_), {}};
        if (pipeline_.budget()) depth.clampedShare = pipeline_.budget()->clampedShare();
        return depth;
    }

    void keepChoice(const gpu::MethodChoice& choice) const {
        for (const gpu::MethodTrial& trial : choice.trials)
            spdlog::info("method {}: {:.1f} ms, {:.1f} dB", methodName(trial.method),
                         trial.milliseconds, trial.psnrDb);
        if (const auto problem = methods_.keep(choice)) spdlog::warn("method: {}", *problem);
    }

    void show(devices::RgbdFrame frame) {
        if (!shown_.depth.empty() && sameBytes(frame.depth, shown_.depth) &&
            sameBytes(frame.color, shown_.color) && pipeline_.isStill()) {
            ++report_.skipped["unchanged"];
            return;
        }
        pipeline_.render(frame, panel_->framebuffer());
        panel_->present();
        if (report_.presented == 0 && pipeline_.choice()) keepChoice(*pipeline_.choice());
        ++report_.presented;
        if (measuresNothing(frame.depth)) ++report_.withoutDepth;
        if (realtime_)
            report_.latencyMs.add(std::chrono::duration<double, std::milli>(
                                      clock_.now() - frame.depth.metadata().capturedAt)
                                      .count());
        shown_ = std::move(frame);
    }

    config::Output output_;
    bool realtime_;
    ChosenDisplay chosen_;
    const calib::DisplayProfile& display_;
    devices::Input input_;
    calib::SensorRig rig_;
    std::unique_ptr<gpu::Panel> panel_;
    gpu::PipelineParams params_;
    MethodMemory methods_;
    gpu::Pipeline pipeline_;
    devices::SteadyClock clock_;
    std::unique_ptr<devices::Feed> feed_;
    devices::RgbdFrame shown_; ///< to tell a picture that did not change
    std::optional<std::uint64_t> framesWanted_;
    devices::TimePoint started_{};
    Report report_;
};

} // namespace

int run(const RunOptions& options) {
    const config::Config config = configuration(options.scene);
    setUpLog(config.log.level);
    const StopSignal stop; // before the window opens: closing it gives the screen saver back
    Session session(options, config);
    session.loop(stop);

    const Report& report = session.accounts();
    spdlog::info("{}", report.summary());
    std::optional<std::filesystem::path> picture = options.snapshot;
    if (!picture && report.presented > 0 && session.offscreen() && !options.frames)
        picture = kOffscreenPicture;
    if (picture && report.presented == 0) {
        spdlog::warn("panel: stopped before the first frame, so there is no picture to write");
    } else if (picture) {
        session.writePicture(*picture);
        spdlog::info("panel: {}", std::filesystem::absolute(*picture).string());
    }
    if (options.report) writeReport(report, *options.report);
    if (session.endedWithoutPicture())
        throw devices::DeviceError(
            "run: cannot show " + config.input + ": it ended without a pair of frames (" +
            std::to_string(report.feed.depth.damaged + report.feed.color.damaged) + " damaged)");
    return EXIT_SUCCESS;
}

} // namespace autostereo::daemon
