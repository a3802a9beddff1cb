// What a session shows where no pair of frames is to be shown.

#include "daemon/session/session.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>

namespace autostereo::daemon {

std::optional<Shown> Session::rest() const {
    if (!realtime_) return std::nullopt; // recordings that are hurried are for no visitor
    return attendance_.rest(clock_.now(), localTime());
}

void Session::showWithoutPair() {
    const devices::TimePoint now = clock_.now();
    const auto states = sensors();
    const auto resting = rest();
    if (!pattern_ && !resting && policy_.wantsColor(now, states)) {
        if (devices::Frame color = feed_->takeColor(); !color.empty())
            return showColorAlone(std::move(color));
    }
    if (!pattern_) enter(resting ? *resting : policy_.decide(now, states));
    const bool idle = !pattern_ && shown_ == Shown::Idle;
    const std::string message = idle ? policy_.message(now, states) : "";
    if (message != message_) {
        if (idle) spdlog::warn("panel: {}", message);
        message_ = message;
        redraw_ = true;
    }
}

void Session::showColorAlone(devices::Frame color) {
    enter(Shown::ColorAlone);
    if (colorAlone_.depth.empty()) {
        const devices::FrameMetadata& depth = last_.depth.metadata();
        const double focusM = screen_.pipeline()->geometry().law.focusM;
        colorAlone_.depth = std::move(*flatPool_.acquire(depth));
        colorAlone_.depth.metadata().hasAmplitude = false;
        const double counts = std::clamp(focusM / depth.depthUnitM, 1.0, 65534.0);
        std::ranges::fill(colorAlone_.depth.depth(),
                          static_cast<std::uint16_t>(std::lround(counts)));
    }
    colorAlone_.depth.metadata().capturedAt = color.metadata().capturedAt;
    colorAlone_.color = std::move(color);
    screen_.show(colorAlone_);
    present();
    policy_.colored(clock_.now());
}

void Session::powerMonitor() {
    const bool resting = !pattern_ && (shown_ == Shown::Nobody || shown_ == Shown::Closed);
    const auto& after = config_.rest.monitorOff;
    const bool off = resting && after && clock_.now() - shownSince_ >= *after;
    gpu::Panel& panel = screen_.panel();
    if (off != panel.monitorIsOn()) return;
    panel.turnMonitor(!off);
    if (off == panel.monitorIsOn()) return; // it cannot
    redraw_ |= !off;
    spdlog::info("panel: monitor {}", off ? "off" : "on");
}

void Session::refreshStanding() {
    const bool standing = !pattern_ && isStanding(shown_) && shown_ != Shown::Closed;
    const bool content = standing && message_.empty() && screen_.panel().monitorIsOn();
    if (!content) screen_.leaveIdle();
    const devices::Duration since = clock_.now() - presentedAt_;
    const bool due = (pattern_ || isStanding(shown_)) && since >= kStillInterval;
    const bool moved = content && since >= kPictureInterval && screen_.advanceIdle(sceneSeconds());
    if (redraw_ || due || moved) presentAgain();
}

void Session::presentAgain() {
    if (screen_.panel().monitorIsOn()) {
        drawAgain();
        return present();
    }
    // A monitor that is off has no vertical sync to wait for; there is nothing to see on it.
    redraw_ = false;
    presentedAt_ = clock_.now();
    watchdog_.pet();
}

void Session::drawAgain() {
    redraw_ = false;
    if (pattern_)
        screen_.showPattern(*pattern_);
    else if (shown_ == Shown::Closed)
        screen_.showBlack();
    else if (isStanding(shown_))
        screen_.showIdle(shown_ == Shown::Idle ? message_ : "", sceneSeconds());
    else if (scene_)
        screen_.showScene(sceneSeconds());
    else if (shown_ == Shown::ColorAlone && !colorAlone_.color.empty())
        screen_.show(colorAlone_);
    else if (!last_.depth.empty())
        screen_.show(last_);
}

} // namespace autostereo::daemon
