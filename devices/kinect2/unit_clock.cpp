#include "devices/kinect2/unit_clock.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace autostereo::devices::kinect2 {

namespace {

constexpr Duration kTick = std::chrono::microseconds(125);
constexpr Duration kFramePeriod = std::chrono::nanoseconds(33'333'333);

/// From one stamp to the other, also backwards, across the wrap.
Duration between(std::uint32_t from, std::uint32_t to) {
    return kTick * static_cast<std::int32_t>(to - from);
}

} // namespace

TimePoint UnitClock::depth(std::uint32_t stamp, TimePoint arrived) {
    const Duration device = tie_ ? tie_->device + between(tie_->stamp, stamp) : Duration(0);
    const TimePoint host = map_.map(device, arrived);
    tie_ = Tie{stamp, device, host};
    return host - kFramePeriod / 2; // nine exposures all over the period
}

TimePoint UnitClock::color(std::uint32_t stamp, float exposureMs, TimePoint arrived) const {
    constexpr float kLongestMs = 100;
    constexpr Duration kFarthest = std::chrono::seconds(1); // then the stamp is wrong
    const float milliseconds =
        std::isfinite(exposureMs) ? std::clamp(exposureMs, 0.0F, kLongestMs) : 0.0F;
    const auto exposure = std::chrono::duration_cast<Duration>(
        std::chrono::duration<float, std::milli>(milliseconds));
    const Duration after = tie_ ? between(tie_->stamp, stamp) : Duration(0);
    const bool believable = tie_ && std::chrono::abs(after) < kFarthest;
    return std::min(believable ? tie_->host + after : arrived, arrived) - exposure / 2;
}

} // namespace autostereo::devices::kinect2
