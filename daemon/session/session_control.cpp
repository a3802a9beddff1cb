// What the operator does to a session while it runs.

#include "daemon/session/scene_content.hpp"
#include "daemon/session/session.hpp"

#include <spdlog/spdlog.h>

#include <chrono>
#include <stdexcept>

namespace autostereo::daemon {

namespace {

/// The device without what is asked of it.
std::string deviceOf(const std::string& uri) { return uri.substr(0, uri.find('?')); }

bool sameInput(const config::Config& a, const config::Config& b) {
    // A rig file may have been written anew.
    return a.input == b.input && a.color == b.color && !a.rig && !b.rig &&
           a.sync.tolerance == b.sync.tolerance &&
           a.reconnect.firstDelay == b.reconnect.firstDelay &&
           a.reconnect.longestDelay == b.reconnect.longestDelay;
}

bool sameDevices(const config::Config& a, const config::Config& b) {
    return deviceOf(a.input) == deviceOf(b.input) &&
           deviceOf(a.color.value_or("")) == deviceOf(b.color.value_or(""));
}

} // namespace

void Session::adjust(const config::Config& config) {
    config_ = config;
    screen_.adjust(config);
    redraw_ = true;
}

std::optional<devices::RecordingRing::Held> Session::lastPictures() const {
    if (recording_.ring() == nullptr) return std::nullopt;
    return recording_.ring()->held();
}

void Session::replace(const config::Config& config) {
    const bool other = !sameInput(config_, config);
    if (other && (scene_ || isScene(config)))
        throw config::ConfigError("input.uri: from or to a scene needs a restart");
    if (other && recording_.counters())
        throw config::ConfigError("input: cannot be another one while it is recorded");
    if (config.output.value_or(output_) != output_)
        throw config::ConfigError("output.kind: needs a restart");
    if (config.refreshHz != config_.refreshHz)
        throw config::ConfigError("output.refresh_hz: needs a restart");
    if (!(config.viewer == config_.viewer)) throw config::ConfigError("viewer: needs a restart");
    if (viewer_ && config.display != config_.display)
        throw config::ConfigError("display.profile: with a viewer it needs a restart");
    if (!(config.ring == config_.ring)) throw config::ConfigError("record: needs a restart");
    // A device can be open only once: another one first shows that it is there.
    std::optional<devices::Input> next;
    if (other && !sameDevices(config_, config)) next = openScene(config, tap());
    screen_.replace(config);
    timesShown_ = 0;
    config_ = config;
    policy_.replace(config.idle);
    attendance_.replace(config.rest);
    report_.input = config.input;
    redraw_ = true;
    if (!other) return;
    opener_.reset();
    if (feed_) before_ = sum(before_, feed_->counters());
    feed_.reset();
    if (next)
        adopt(std::move(*next));
    else
        opener_ = std::make_unique<InputOpener>(config_, tap());
}

void Session::showPattern(const std::optional<Pattern>& pattern) {
    if (pattern) screen_.showPattern(*pattern); // says whether the display can
    pattern_ = pattern;
    message_.clear();
    shownSince_ = clock_.now();
    redraw_ = true;
}

gpu::RgbImage Session::picture() {
    if (!offscreen()) drawAgain(); // a window's picture is gone once it was presented
    return screen_.picture();
}

gpu::RgbImage Session::preview(const PreviewRequest& request) {
    const bool cameras = shown_ == Shown::Live || shown_ == Shown::Frozen;
    if (!cameras || pattern_ || last_.depth.empty())
        throw std::runtime_error(std::string("preview: no camera's picture is shown (") +
                                 (pattern_ ? "pattern" : shownName(shown_)) + ')');
    gpu::RgbImage image = screen_.preview(request);
    if (viewer_) redraw_ = true; // else it would be shown again as it was prepared before
    return image;
}

Status Session::status() {
    Status status;
    status.now = clock_.now();
    const auto since = [&](devices::TimePoint then) {
        return std::chrono::duration<double>(status.now - then).count();
    };
    status.shown = pattern_ ? "pattern" : shownName(shown_);
    status.message = message_;
    status.shownForS = since(shownSince_);
    status.pictureAgeS = since(presentedAt_);
    status.rate = rate_;
    status.width = screen_.panel().width();
    status.height = screen_.panel().height();
    status.panel = screen_.panel().description();
    status.monitorOn = screen_.panel().monitorIsOn();
    if (opener_) status.inputProblem = opener_->problem();
    status.sensors = sensors();
    const bool pair = shown_ == Shown::Live || shown_ == Shown::Frozen;
    if (pair && !pattern_ && !last_.depth.empty())
        status.capturedAt = last_.depth.metadata().capturedAt;
    status.method = gpu::methodName(config_.pipeline.synthesis.method);
    status.focusM = config_.pipeline.budget.focusM;
    status.scale = config_.pipeline.budget.depthScale;
    status.brightness = config_.brightness;
    status.flat = config_.flat;
    if (viewer_) status.viewer = viewer_->status(status.now);
    return status;
}

} // namespace autostereo::daemon
