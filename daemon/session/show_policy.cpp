#include "daemon/session/show_policy.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace autostereo::daemon {

namespace {

/// A picture is live so long after it was captured, not counting the time to draw it; or as many
/// spacings of the last pairs, for slow cameras and panels.
constexpr std::chrono::milliseconds kFresh{200};
constexpr int kSpacings = 3;
constexpr std::chrono::hours kOldest{1}; // older is as bad
/// No camera is as slow as that: it was away.
constexpr std::chrono::seconds kLongestSpacing{1};
/// Cameras that are open get so long for their first pair before the panel says anything about it.
constexpr std::chrono::milliseconds kStart{1000};

} // namespace

const char* shownName(Shown shown) {
    switch (shown) {
    case Shown::Starting:
        return "starting";
    case Shown::Live:
        return "live";
    case Shown::Frozen:
        return "frozen";
    case Shown::ColorAlone:
        return "color-alone";
    case Shown::Nobody:
        return "nobody";
    case Shown::Closed:
        return "closed";
    case Shown::Idle:
        break;
    }
    return "idle";
}

void ShowPolicy::opened(devices::TimePoint now) {
    start_ = now;
    arrived_ = pair_ = color_ = std::nullopt;
    spacing_ = earlier_ = devices::Duration{0};
}

bool ShowPolicy::arrived(devices::TimePoint now, devices::TimePoint capturedAt) {
    // A stamp from the future is as good as new; damaged ones hold the extremes of the type.
    age_ = now - std::clamp(capturedAt, now - kOldest, now);
    earlier_ = std::exchange(spacing_, devices::Duration{0});
    if (arrived_) spacing_ = std::min<devices::Duration>(now - *arrived_, kLongestSpacing);
    arrived_ = now;
    return age_ <= patience();
}

devices::Duration ShowPolicy::patience() const {
    // One gap, or one pair right behind another, tells nothing of the cameras' rate.
    return std::max<devices::Duration>(kFresh, kSpacings * std::min(spacing_, earlier_));
}

bool ShowPolicy::silent(const devices::SensorStatus& sensor, devices::TimePoint now) const {
    if (sensor.state != devices::SensorState::Streaming) return true;
    return sensor.lastFrame && now - *sensor.lastFrame > patience();
}

Shown ShowPolicy::decide(devices::TimePoint now,
                         const std::optional<devices::SensorStatuses>& sensors) const {
    if (pair_ && now - *pair_ <= patience()) return Shown::Live;
    if (pair_ && now - *pair_ <= patience() + params_.freeze) return Shown::Frozen;
    if (color_ && now - *color_ <= patience()) return Shown::ColorAlone;
    const bool starting = sensors && !pair_ && now - start_ <= kStart;
    return starting ? Shown::Starting : Shown::Idle;
}

bool ShowPolicy::wantsColor(devices::TimePoint now,
                            const std::optional<devices::SensorStatuses>& sensors) const {
    if (!sensors || !pair_) return false; // where nothing was seen yet, depth may only be late
    return now - *pair_ > patience() + params_.freeze && silent(sensors->depth, now) &&
           !silent(sensors->color, now);
}

const std::string&
ShowPolicy::message(devices::TimePoint now,
                    const std::optional<devices::SensorStatuses>& sensors) const {
    if (!sensors) return now - start_ <= kStart ? params_.startingText : params_.noInputText;
    const bool depth = silent(sensors->depth, now), color = silent(sensors->color, now);
    if (depth && color) return params_.bothLostText;
    if (depth) return params_.depthLostText;
    return color ? params_.colorLostText : params_.noPairsText;
}

} // namespace autostereo::daemon
