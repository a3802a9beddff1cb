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

void Session::drawAgain() {
    redraw_ = false;
    if (pattern_)
        screen_.showPattern(*pattern_);
    else if (shown_ == Shown::Closed)
        screen_.showBlack();
    else if (isStanding(shown_))
        screen_.showMessage(shown_ == Shown::Idle ? message_ : "");
    else if (scene_)
        screen_.showScene(sceneSeconds());
    else if (shown_ == Shown::ColorAlone && !colorAlone_.color.empty())
        screen_.show(colorAlone_);
    else if (!last_.depth.empty())
        screen_.show(last_);
}

} // namespace autostereo::daemon
