#include "daemon/session/idle_recording.hpp"

#include "daemon/session/message_panel.hpp"
#include "daemon/wiring.hpp"

#include <utility>

namespace autostereo::daemon {

namespace {

/// A recording that was just opened gives its first pair well within this.
constexpr std::chrono::milliseconds kFirstPairWait{200};

/// The recording stands alone: with its own calibration, or the example's, but nobody else's.
config::Config forRecording(config::Config config) {
    config.input = config.idle.content;
    config.color.reset();
    config.rig.reset();
    // Trying all methods takes seconds, in which somebody may come.
    auto& method = config.pipeline.synthesis.method;
    if (method == gpu::Method::Auto) method = gpu::Method::Direct;
    return config;
}

} // namespace

IdleRecording::IdleRecording(const config::Config& config) : config_(forRecording(config)) {
    static_cast<void>(openScene(config_));
}

void IdleRecording::replace(const config::Config& config) {
    config_ = forRecording(config);
    pipeline_.reset();
}

void IdleRecording::leave() {
    feed_.reset();
    newest_ = {};
    pipeline_.reset();
}

void IdleRecording::play() {
    devices::Input input = openScene(config_);
    rig_ = input.rig;
    constexpr bool kLoop = true;
    feed_ = openFeed(std::move(input), config_, config::Speed::Realtime, kLoop, clock_);
    takeNewest(kFirstPairWait);
}

void IdleRecording::takeNewest(std::chrono::milliseconds wait) {
    auto pair = feed_->next(wait);
    if (!pair) return;
    newest_ = std::move(*pair);
    prepared_ = false;
}

bool IdleRecording::advance(double /*seconds*/) {
    if (feed_) takeNewest(std::chrono::milliseconds(0));
    return !newest_.depth.empty() && !prepared_;
}

void IdleRecording::draw(double /*seconds*/, const StandingTarget& target) {
    if (!feed_) play();
    if (newest_.depth.empty()) return drawMessage({}, "", target);
    if (!pipeline_) {
        pipeline_.emplace(pipelineParams(config_, true), *rig_, target.display, target.width,
                          target.height);
        prepared_ = false;
    }
    if (!std::exchange(prepared_, true)) pipeline_->prepare(newest_);
    pipeline_->show(target.framebuffer);
}

} // namespace autostereo::daemon
