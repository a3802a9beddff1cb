#include "devices/v4l2/frame_clock.hpp"

#include <algorithm>
#include <chrono>

namespace autostereo::devices::v4l2 {

namespace {

/// A frame is handed over within this of its stamp, or the stamp is on another clock.
constexpr Duration kFarthest = std::chrono::milliseconds(500);

/// Stamps can be anything: differences are taken modulo 2^64 instead of overflowing.
Duration wrapped(std::uint64_t count) { return Duration(static_cast<Duration::rep>(count)); }
std::uint64_t bits(Duration duration) { return static_cast<std::uint64_t>(duration.count()); }

} // namespace

TimePoint FrameClock::midExposure(Duration stamp, StampOf what, Duration exposure, TimePoint now) {
    Duration time = wrapped(bits(stamp) + bits(shift_));
    const Duration away = wrapped(bits(now.time_since_epoch()) - bits(time));
    if (away > kFarthest || away < -kFarthest) {
        shift_ = wrapped(bits(now.time_since_epoch()) - bits(stamp));
        time = now.time_since_epoch();
        ++shifts_;
    }
    const Duration half = exposure / 2;
    time += what == StampOf::ExposureStart ? half : -half;
    return std::min(TimePoint(time), now);
}

} // namespace autostereo::devices::v4l2
