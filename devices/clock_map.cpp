#include "devices/clock_map.hpp"

#include <algorithm>
#include <chrono>

namespace autostereo::devices {

TimePoint ClockMap::map(Duration device, TimePoint arrived) {
    constexpr Duration kJump = std::chrono::seconds(1);
    constexpr int kCreep = 10'000; // of the time that passed: crystals differ by less
    const Duration difference = arrived.time_since_epoch() - device;
    const bool jumped = last_ && (device < last_->device || difference > last_->offset + kJump ||
                                  difference < last_->offset - kJump);
    if (!last_ || jumped) {
        const TimePoint result = last_ ? std::max(last_->result, arrived) : arrived;
        last_ = Seen{device, arrived, difference, result};
        return result;
    }
    const Duration creep = (device - last_->device) / kCreep;
    const Duration offset = std::min(difference, last_->offset + creep);
    const TimePoint result = std::max(last_->result, TimePoint(device + offset));
    last_ = Seen{device, arrived, offset, result};
    return result;
}

} // namespace autostereo::devices
