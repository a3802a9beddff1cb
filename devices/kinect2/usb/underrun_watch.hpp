#pragma once

#include "devices/clock.hpp"

#include <cstdint>
#include <optional>

namespace autostereo::devices::kinect2 {

/// Whether an isochronous endpoint may have been without a transfer for a while. What the device
/// sends meanwhile is lost, and neither kernel nor libusb says so: the next transfer starts "as
/// soon as possible". Times are all that is known, so a lower bound of the end of the queue is
/// kept: a transfer starts neither before it was submitted nor before its predecessor ended, and
/// one that has not ended yet ends later. The latter may be told late by a busy machine: it counts
/// where it held at every look for a second. Misses no gap then; calls a transfer late that came in
/// time by less than `kLead` and about two transfers. Thread-bound.
class UnderrunWatch {
  public:
    /// Controllers take transfers some time before they start: 895 us and the scheduling threshold
    /// (a millisecond at most) with xHCI under Linux. Half as much again for the way there.
    static constexpr Duration kLead = std::chrono::milliseconds(3);
    /// How much faster than its nominal rate the bus may be: USB allows 500 ppm, the host's clock
    /// may be slewed by as much.
    static constexpr double kFaster = 0.002;

    /// `span`: of one transfer on the bus.
    explicit UnderrunWatch(Duration span);

    /// A transfer was handed over between these two times; transfers are sent in this order. True:
    /// it may start after a gap.
    [[nodiscard]] bool submitted(TimePoint before, TimePoint after);
    /// None of the last `onTheirWay` transfers had ended then.
    void noneEnded(TimePoint time, int onTheirWay);
    /// A transfer failed, and may have done so before its time.
    void failed(TimePoint time);

  private:
    Duration span_;                     ///< at least
    std::optional<TimePoint> queueEnd_; ///< not before; none: nothing was submitted yet
    std::int64_t submitted_ = 0;
    /// When the first of all transfers started, had none ever been late: the earliest of the looks
    /// of this second.
    TimePoint earliest_ = TimePoint::max();
    TimePoint second_{}; ///< when it began
};

} // namespace autostereo::devices::kinect2
