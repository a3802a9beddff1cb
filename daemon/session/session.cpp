#include "daemon/session/session.hpp"

#include "daemon/picture_files.hpp"
#include "daemon/session/scene_content.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cstring>

namespace autostereo::daemon {

namespace {

constexpr std::uint64_t kOffscreenFrames = 120; // without --frames
constexpr std::chrono::seconds kLogInterval{10};
constexpr std::chrono::seconds kRateInterval{1};
constexpr std::chrono::milliseconds kFrameWait{16};
/// Between frames a viewer's picture follows at a display's rate, 60 Hz and some.
constexpr std::chrono::milliseconds kEyeWait{4}, kEyeInterval{12};

bool sameForm(const devices::FrameMetadata& a, const devices::FrameMetadata& b) {
    return a.format == b.format && a.width == b.width && a.height == b.height &&
           a.depthUnitM == b.depthUnitM && a.matrix == b.matrix && a.range == b.range;
}

bool samePicture(const devices::Frame& a, const devices::Frame& b) {
    const auto x = a.pixels(), y = b.pixels();
    return sameForm(a.metadata(), b.metadata()) && std::memcmp(x.data(), y.data(), x.size()) == 0;
}

bool measuresNothing(const devices::Frame& depth) {
    return std::ranges::all_of(depth.depth(),
                               [](std::uint16_t count) { return count == 0 || count == 0xffff; });
}

double seconds(devices::Duration duration) {
    return std::chrono::duration<double>(duration).count();
}

} // namespace

Session::Session(const RunOptions& options, const config::Config& config, Tap sensors)
    : config_(config), output_(options.output.value_or(chooseOutput(config))),
      realtime_(options.speed.value_or(config::Speed::Realtime) == config::Speed::Realtime),
      sensors_(std::move(sensors)),
      recording_(options.record, options.recordRaw, options.speed.value_or(config::Speed::Realtime),
                 config.ring),
      input_(isScene(config) || waitsForInput() ? std::nullopt
                                                : std::make_optional(openScene(config, tap()))),
      scene_(isScene(config) ? std::make_optional(openMeshScene(config.input)) : std::nullopt),
      screen_(config, output_, options.force), policy_(config.idle, clock_.now()),
      attendance_(config.rest, clock_.now()), shownSince_(clock_.now()),
      presentedAt_(clock_.now()) {
    report_.input = config.input;
    report_.stageNames.assign(gpu::Pipeline::kStages.begin(), gpu::Pipeline::kStages.end());
    report_.stageMs.resize(report_.stageNames.size());
    if (scene_ && (options.record || options.recordRaw))
        throw UsageError("run: cannot record " + config.input + ": a scene has no cameras");
    if (!scene_) openViewer();
    screen_.onStageTime([this](std::size_t stage, double ms) { report_.stageMs[stage].add(ms); });
    if (scene_)
        startScene();
    else if (input_)
        adopt(std::move(*input_));
    else
        waitForInput();
    input_.reset();
    if (output_ == config::Output::Offscreen) framesWanted_ = kOffscreenFrames;
    if (options.frames) framesWanted_ = *options.frames;
    started_ = clock_.now();
    ratedAt_ = started_;
    logAt_ = started_ + kLogInterval;
    watchdog_.ready();
}

void Session::openViewer() {
    const auto start = realtime_ ? std::make_optional(clock_.now()) : std::nullopt;
    viewer_ = Viewer::open(config_.viewer, screen_.display(), start, clock_);
    if (!viewer_) return;
    if (!realtime_ && viewer_->isLive())
        throw UsageError("--speed max: " + config_.viewer.source +
                         " is live; only recordings can be hurried");
    screen_.followEyes([this] { return viewer_->eyes(realtime_ ? clock_.now() : frameAt_); });
}

bool Session::waitsForInput() const {
    return realtime_ && config_.wait.value_or(output_ == config::Output::Window);
}

Tap Session::tap() {
    Tap record = recording_.tap(config_);
    if (!sensors_) return record;
    return [sensors = sensors_, record](devices::Input input) {
        input = sensors(std::move(input));
        return record ? record(std::move(input)) : std::move(input);
    };
}

void Session::adopt(devices::Input input) {
    const calib::SensorRig rig = *input.rig;
    depthIsLive_ = input.depthIsLive;
    const bool loop = output_ == config::Output::Window; // a kiosk goes on
    auto feed = openFeed(std::move(input), config_,
                         realtime_ ? config::Speed::Realtime : config::Speed::Max, loop, clock_);
    screen_.start(rig);
    if (viewer_) viewer_->start(rig);
    feed_ = std::move(feed);
    last_ = {};
    colorAlone_ = {};
    policy_.opened(clock_.now());
}

void Session::waitForInput() {
    showWithoutPair(); // there is a picture before anything else is tried
    drawAgain();
    present();
    opener_ = std::make_unique<InputOpener>(config_, tap());
}

void Session::takeInput() {
    if (!opener_) return;
    if (auto input = opener_->take()) {
        opener_.reset();
        adopt(std::move(*input));
    }
}

bool Session::finished() const {
    // A pair that came too late to be shown is none of those that were asked for.
    const auto late = report_.skipped.find("stale");
    const std::uint64_t pairs = report_.presented + report_.skippedTotal() -
                                (late == report_.skipped.end() ? 0 : late->second);
    return (feed_ && feed_->ended()) || (framesWanted_ && pairs >= *framesWanted_);
}

bool Session::step() {
    if (screen_.panel().closed() || finished()) return false;
    if (scene_) return stepScene();
    takeInput();
    std::optional<devices::RgbdFrame> frame;
    if (feed_)
        frame = feed_->next(viewer_ ? kEyeWait : kFrameWait);
    else
        clock_.sleepUntil(clock_.now() + kFrameWait);
    if (frame && isFresh(*frame))
        show(std::move(*frame));
    else if (realtime_)
        showWithoutPair();
    if (!frame) followViewer();
    powerMonitor();
    refreshStanding();
    screen_.panel().pollEvents();
    log();
    return true;
}

bool Session::isFresh(const devices::RgbdFrame& frame) {
    const devices::TimePoint now = clock_.now();
    // Recordings play as fast as they can be read: what is behind is their time, not the picture.
    const bool fresh = policy_.arrived(now, depthIsLive_ ? frame.depth.metadata().capturedAt : now);
    if (fresh || !realtime_) return true;
    ++report_.skipped["stale"];
    return false;
}

void Session::show(devices::RgbdFrame frame) {
    const devices::TimePoint takenAt = clock_.now();
    attendance_.saw(frame.depth, takenAt);
    if (viewer_) viewer_->saw(frame);
    const auto resting = rest();
    if (!pattern_) enter(resting.value_or(Shown::Live));
    policy_.presented(takenAt);
    const bool same = !last_.depth.empty() && samePicture(frame.depth, last_.depth) &&
                      samePicture(frame.color, last_.color);
    if (!same) timesShown_ = 0;
    othersShown_ |= !same && !last_.depth.empty();
    // What never changed leaves nothing older in the pipeline's memory.
    const auto times = othersShown_ || timesShown_ == 0 ? timesShown_ : ~std::uint64_t{0};
    if (pattern_ || resting || (same && !redraw_ && screen_.pipeline()->isStill(times))) {
        ++report_.skipped[pattern_ ? "pattern" : resting ? shownName(*resting) : "unchanged"];
        last_ = std::move(frame);
        if (!pattern_) watchdog_.pet(); // what is on the panel is the newest there is
        followViewer();
        return;
    }
    frameAt_ = frame.depth.metadata().capturedAt;
    screen_.show(frame);
    screen_.finish();
    const devices::TimePoint drawnAt = clock_.now();
    present();
    if (realtime_) noteLatency(frame, takenAt, drawnAt);
    ++timesShown_;
    policy_.presented(clock_.now());
    if (report_.presented == 0) screen_.keepChoice();
    ++report_.presented;
    if (measuresNothing(frame.depth)) ++report_.withoutDepth;
    last_ = std::move(frame);
}

void Session::noteLatency(const devices::RgbdFrame& frame, devices::TimePoint takenAt,
                          devices::TimePoint drawnAt) {
    const auto ms = [](devices::Duration part) { return 1e3 * seconds(part); };
    const devices::FrameMetadata& depth = frame.depth.metadata();
    const devices::TimePoint pairedAt = std::max(depth.arrivedAt, frame.color.metadata().arrivedAt);
    report_.latencyMs.add(ms(presentedAt_ - depth.capturedAt));
    report_.latencyHistogram.add(ms(presentedAt_ - depth.capturedAt));
    report_.latencyParts.transfer.add(ms(depth.arrivedAt - depth.capturedAt));
    report_.latencyParts.pairing.add(ms(pairedAt - depth.arrivedAt));
    report_.latencyParts.wait.add(ms(takenAt - pairedAt));
    report_.latencyParts.draw.add(ms(drawnAt - takenAt));
    report_.latencyParts.swap.add(ms(presentedAt_ - drawnAt));
}

void Session::followViewer() {
    const bool shown = shown_ == Shown::Live || shown_ == Shown::Frozen;
    if (!viewer_ || !shown || pattern_ || redraw_ || last_.depth.empty()) return;
    if (realtime_ && clock_.now() - presentedAt_ < kEyeInterval) return;
    frameAt_ = last_.depth.metadata().capturedAt;
    screen_.showAgain();
    present();
}

void Session::enter(Shown shown) {
    screen_.setFlat(shown == Shown::ColorAlone ||
                    (shown == Shown::Frozen && shown_ == Shown::ColorAlone));
    if (shown == shown_) return;
    if (shown == Shown::Live) message_.clear();
    spdlog::info("panel: {} after {:.1f} s of {}", shownName(shown),
                 seconds(clock_.now() - shownSince_), shownName(shown_));
    // What was there before the standing picture is on the panel no more, even if it comes again.
    redraw_ |= isStanding(shown) || isStanding(shown_);
    shown_ = shown;
    shownSince_ = clock_.now();
    powerMonitor();
}

void Session::present() {
    redraw_ = false;
    screen_.panel().present();
    presentedAt_ = clock_.now();
    watchdog_.pet();
}

void Session::log() {
    const devices::TimePoint now = clock_.now();
    if (now - ratedAt_ >= kRateInterval) {
        rate_ = static_cast<double>(report_.presented - ratedPictures_) / seconds(now - ratedAt_);
        ratedPictures_ = report_.presented;
        ratedAt_ = now;
    }
    if (now < logAt_) return;
    logAt_ = now + kLogInterval;
    spdlog::info("{}", accounts().summary());
}

std::optional<devices::SensorStatuses> Session::sensors() const {
    if (!feed_) return std::nullopt;
    return feed_->sensors();
}

const Report& Session::accounts() {
    report_.feed = feed_ ? sum(before_, feed_->counters()) : before_;
    screen_.account(report_);
    report_.recording = recording_.counters();
    report_.seconds = seconds(clock_.now() - started_);
    return report_;
}

const Report& Session::close() {
    watchdog_.stopping();
    static_cast<void>(accounts());
    endedWithoutPicture_ = feed_ && feed_->ended() && report_.presented == 0;
    opener_.reset();
    feed_.reset();
    recording_.finish();
    report_.recording = recording_.counters();
    return report_;
}

void Session::writePicture(const std::filesystem::path& file) {
    writePicturePng(file, screen_.picture());
}

} // namespace autostereo::daemon
