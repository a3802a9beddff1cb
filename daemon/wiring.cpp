#include "daemon/wiring.hpp"

#include "config/units.hpp"
#include "daemon/find_display.hpp"
#include "devices/display/link_state.hpp"
#include "devices/join_inputs.hpp"
#include "devices/live_feed.hpp"
#include "devices/paced_source.hpp"
#include "devices/record/recording_source.hpp"
#include "devices/replay_feed.hpp"
#include "devices/single_stream.hpp"
#include "devices/uri.hpp"
#include "gpu/gl/error.hpp"
#include "gpu/offscreen_panel.hpp"
#include "gpu/window_panel.hpp"

#include <spdlog/spdlog.h>

#include <cstdlib>

namespace autostereo::daemon {

namespace {

constexpr const char* kSystemConfig = "/etc/autostereo/autostereo.toml";

#ifdef NDEBUG
constexpr bool kDebugContext = false;
#else
constexpr bool kDebugContext = true;
#endif

bool isSet(const char* variable) {
    const char* value = std::getenv(variable);
    return value != nullptr && *value != '\0';
}

/// What night light and colour profiles load into the display server.
void warnAboutRamp(const gpu::WindowPanel& window) {
    const auto ramp = window.gammaRamp();
    if (!ramp) return;
    devices::LinkState link;
    link.gammaIsIdentity = devices::isIdentityRamp(ramp->red) &&
                           devices::isIdentityRamp(ramp->green) &&
                           devices::isIdentityRamp(ramp->blue);
    for (const devices::LinkProblem& problem : devices::linkProblems(link))
        spdlog::warn("window: {}", problem.text);
}

config::Config configurationFile(const SceneOptions& options) {
    if (options.config) return config::loadConfig(*options.config);
    if (std::filesystem::exists(kSystemConfig)) return config::loadConfig(kSystemConfig);
    return config::defaultConfig();
}

} // namespace

config::Config configuration(const SceneOptions& options) {
    config::Config config = configurationFile(options);
    if (options.input) config.input = *options.input;
    if (options.display) config.display = *options.display;
    if (options.color) config.color = options.color;
    if (options.rig) config.rig = options.rig->string();
    return config;
}

gpu::PipelineParams pipelineParams(const config::Config& config, bool live) {
    gpu::PipelineParams params = config.pipeline;
    const bool open = !params.budget.focusM || !params.budget.depthScale;
    if (config.flat) params.budget.depthScale = 0;
    params.budget.follow = open && !config.flat &&
                           (config.depthFollows == config::Following::Always ||
                            (live && config.depthFollows == config::Following::Live));
    return params;
}

calib::DisplayProfile chooseDisplay(const config::Config& config) {
    calib::DisplayProfile display =
        config::loadDisplay(config.display.empty() ? "preview" : config.display);
    warnOfPlaceholder(display);
    return display;
}

ChosenDisplay chooseWindowDisplay(const config::Config& config, bool force) {
    const DisplayPlaces places = DisplayPlaces::ofSystem();
    ChosenDisplay chosen;
    if (config.display.empty()) {
        FoundDisplay found = findDisplay(places);
        for (const std::string& warning : found.warnings)
            spdlog::warn("display: {}", warning);
        if (found.profile) {
            warnOfPlaceholder(*found.profile);
            chosen = {std::move(*found.profile), found.connector};
        }
    }
    if (chosen.profile.name.empty()) chosen.profile = chooseDisplay(config);
    const bool anyMode = chosen.profile.width == 0; // no optics whose views could mix
    if (anyMode) return chosen;
    for (const auto& problem : linkProblemsOf(places, chosen.profile, chosen.connector)) {
        if (problem.severity == devices::LinkProblem::Severity::Refuse && !force)
            throw gpu::DisplayNotFound("display: " + chosen.profile.name + " cannot be shown: " +
                                       problem.text + " (--force shows it all the same)");
        spdlog::warn("display: {}", problem.text);
    }
    return chosen;
}

void warnOfPlaceholder(const calib::DisplayProfile& display) {
    if (display.placeholder)
        spdlog::warn("display {}: its numbers are a placeholder; use this unit's own calibration",
                     display.name);
}

devices::Input openScene(const config::Config& config, const Tap& tap) {
    std::optional<calib::SensorRig> rig;
    if (config.rig) rig = config::loadRig(*config.rig);
    devices::Input input = devices::openInput(config.input, rig);
    if (config.color)
        input = devices::joined(std::move(input), devices::openInput(*config.color, rig), rig);
    if (!input.rig) {
        input.rig = config::exampleRig();
        input.warnings.push_back("no calibration comes with " + config.input +
                                 ": nominal cameras are assumed; give --rig");
    }
    for (const std::string& warning : input.warnings)
        spdlog::warn("{}", warning);
    spdlog::info("input: {}", input.description);
    if (tap) input = tap(std::move(input));
    return devices::completeStreams(std::move(input));
}

Recording::Recording(std::optional<std::filesystem::path> file,
                     std::optional<std::filesystem::path> raw, config::Speed speed,
                     const devices::RingParams& ring)
    : file_(std::move(file)), rawFile_(std::move(raw)), speed_(speed) {
    if (ring.length == devices::Duration{0}) return;
    ring_ = std::make_shared<devices::RecordingRing>(ring);
    spdlog::info("record: the cameras' last {:g} s stay in memory, {} MiB at most",
                 std::chrono::duration<double>(ring.length).count(), ring.mostBytes >> 20U);
}

Tap Recording::tap(const config::Config& config) {
    if (!file_ && !rawFile_ && !ring_) return {};
    for (const auto& file : {file_, rawFile_})
        for (const std::string& input : {config.input, config.color.value_or(config.input)}) {
            std::error_code none; // a file that is not there is no input
            if (file && std::filesystem::equivalent(*file, devices::parseUri(input).path, none))
                throw UsageError("cannot record to " + file->string() +
                                 ": it is the input itself, which would be lost; name another "
                                 "file");
        }
    return [this](devices::Input input) { return begin(std::move(input)); };
}

devices::Input Recording::begin(devices::Input input) {
    using WhenBehind = devices::Recorder::WhenBehind;
    if (rawFile_) {
        if (!input.recordRaw)
            throw UsageError("--record-raw: " + input.uri +
                             " has nothing below a decoder to be recorded (kinect2: has)");
        raw_ = input.recordRaw(*rawFile_);
    }
    if (file_) {
        recorder_ = std::make_shared<devices::Recorder>(
            *file_, input, speed_ == config::Speed::Max ? WhenBehind::Wait : WhenBehind::LeaveOut);
        input = devices::recorded(std::move(input), recorder_);
    }
    if (ring_) {
        ring_->begin(devices::headOf(input));
        input = devices::recorded(std::move(input), ring_);
    }
    return input;
}

void Recording::finish() {
    const auto log = [](const std::filesystem::path& file, const char* of, const auto& counters) {
        spdlog::info("recording: {}: {} {}, {:.1f} MiB, {} left out", file.string(),
                     counters.written, of, static_cast<double>(counters.bytes) / (1024 * 1024),
                     counters.leftOut);
    };
    if (raw_) {
        raw_->finish();
        log(*rawFile_, "records", raw_->counters());
    }
    if (!recorder_) return;
    recorder_->finish();
    log(*file_, "pictures", recorder_->counters());
}

std::optional<devices::Recorder::Counters> Recording::counters() const {
    if (!recorder_) return std::nullopt;
    return recorder_->counters();
}

std::string Recording::rawError() const { return raw_ ? raw_->counters().error : std::string(); }

std::unique_ptr<devices::Feed> openFeed(devices::Input input, const config::Config& config,
                                        config::Speed speed, bool loop, devices::Clock& clock) {
    if (speed == config::Speed::Max && (input.depthIsLive || input.colorIsLive))
        throw UsageError("--speed max: " + input.uri + " is live; only recordings can be hurried");
    devices::SyncParams sync = config.sync;
    if (input.rig)
        sync.colorLate =
            config::units::durationFromMs(config::units::msFromSeconds(input.rig->colorLateS));
    if (speed == config::Speed::Max)
        return std::make_unique<devices::ReplayFeed>(std::move(input), sync, loop);
    return std::make_unique<devices::LiveFeed>(devices::paced(std::move(input), clock, loop), clock,
                                               sync, config.reconnect);
}

config::Output chooseOutput(const config::Config& config) {
    if (config.output) return *config.output;
    return isSet("DISPLAY") || isSet("WAYLAND_DISPLAY") ? config::Output::Window
                                                        : config::Output::Offscreen;
}

std::unique_ptr<gpu::Panel> openPanel(const calib::DisplayProfile& display, config::Output output,
                                      bool force, double refreshHz, const std::string& connector) {
    if (output == config::Output::Window) {
        auto window = std::make_unique<gpu::WindowPanel>(
            gpu::MonitorRequest{display.width, display.height, connector, force}, kDebugContext);
        warnAboutRamp(*window);
        return window;
    }
    const PanelSize size = offscreenSize(display);
    return std::make_unique<gpu::OffscreenPanel>(size.width, size.height, kDebugContext, refreshHz);
}

PanelSize offscreenSize(const calib::DisplayProfile& display) {
    if (display.width == 0) return {1920, 1080};
    return {display.width, display.height};
}

} // namespace autostereo::daemon
