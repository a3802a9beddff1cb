#include "devices/playback_epoch.hpp"

#include <algorithm>
#include <chrono>

namespace autostereo::devices {

namespace {

constexpr Duration kLongestRecording = std::chrono::hours(24 * 30);
constexpr Duration kUsualPeriod = std::chrono::milliseconds(33);

} // namespace

PlaybackEpoch::PlaybackEpoch(TimePoint mediaStart, Duration period, int streams)
    : mediaStart_(mediaStart), period_(period > Duration{0} ? period : kUsualPeriod),
      streams_(streams) {}

void PlaybackEpoch::start(TimePoint origin) {
    const std::scoped_lock lock(mutex_);
    if (started_) return;
    started_ = true;
    origin_ = origin;
}

TimePoint PlaybackEpoch::timeOf(TimePoint media) const {
    const std::scoped_lock lock(mutex_);
    const TimePoint credible = std::clamp(media, mediaStart_, mediaStart_ + kLongestRecording);
    return origin_ + (credible - mediaStart_);
}

void PlaybackEpoch::finish(TimePoint last) {
    const std::scoped_lock lock(mutex_);
    latest_ = finished_ == 0 ? last : std::max(latest_, last);
    if (++finished_ < streams_) return;
    finished_ = 0;
    ++round_;
    origin_ = std::max(origin_, latest_) + period_;
}

int PlaybackEpoch::round() const {
    const std::scoped_lock lock(mutex_);
    return round_;
}

} // namespace autostereo::devices
