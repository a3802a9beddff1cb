#pragma once

#include "devices/clock.hpp"

#include <cstdint>

namespace autostereo::devices::v4l2 {

/// What a driver's time stamp marks.
enum class StampOf : std::uint8_t {
    ExposureStart,
    ReceptionStart, ///< uvcvideo: the first row has been exposed by then
    FrameEnd,
};

/// A driver's time stamps -> the middle of the exposure on the host's monotonic clock. Stamps that
/// are far from that clock (another clock, a wrap, a step) are shifted onto it once and then
/// followed: their distances are better than the times at which frames arrive. Thread-bound.
class FrameClock {
  public:
    /// `stamp` on the driver's clock; `exposure` 0: not known. Never later than `now`.
    [[nodiscard]] TimePoint midExposure(Duration stamp, StampOf what, Duration exposure,
                                        TimePoint now);
    /// How often the stamps had to be shifted; the first time included.
    [[nodiscard]] std::uint64_t shifts() const { return shifts_; }

  private:
    Duration shift_{0};
    std::uint64_t shifts_ = 0;
};

} // namespace autostereo::devices::v4l2
