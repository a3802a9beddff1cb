#pragma once

#include "devices/clock.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace autostereo::devices {

/// A number that a camera read off a panel.
struct SeenNumber {
    unsigned number = 0;
    TimePoint capturedAt; ///< middle of the exposure
    TimePoint arrivedAt;  ///< at the host
};

/// How long a panel takes to show what was swapped.
struct PanelDelay {
    /// Of each reading, from the swap until the camera's light, and until its picture was here. A
    /// number stands for a while: counted from the middle of that, so they are right on average and
    /// each to within half of how long a number stood.
    std::vector<Duration> toLight, toArrival;
    /// One delay that fits all readings lies between these: seen at t, number k had been swapped
    /// long enough, k + 1 not yet. `least` > `most`: the delay varied.
    Duration least{Duration::min()}, most{Duration::max()};
    Duration longestStood{0};
    std::size_t unmatched = 0; ///< readings of a number that was not shown a second before, or last
};

/// `swaps`: when number k = 0, 1, ... was swapped. Pure.
[[nodiscard]] PanelDelay panelDelay(std::span<const TimePoint> swaps,
                                    std::span<const SeenNumber> seen);

} // namespace autostereo::devices
