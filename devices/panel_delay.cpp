#include "devices/panel_delay.hpp"

#include <algorithm>

namespace autostereo::devices {

namespace {

/// Panels with all their processing take a tenth of it; misread numbers are farther off.
constexpr Duration kLongestDelay = std::chrono::seconds(1);

} // namespace

PanelDelay panelDelay(std::span<const TimePoint> swaps, std::span<const SeenNumber> seen) {
    PanelDelay delay;
    for (const SeenNumber& reading : seen) {
        const std::size_t k = reading.number;
        const bool ended = k + 1 < swaps.size(); // it is known how long the number stood
        const Duration since = ended ? reading.capturedAt - swaps[k] : Duration{-1};
        if (since < Duration{0} || since > kLongestDelay) {
            ++delay.unmatched;
            continue;
        }
        const Duration stood = swaps[k + 1] - swaps[k];
        delay.toLight.push_back(since - stood / 2);
        delay.toArrival.push_back(reading.arrivedAt - swaps[k] - stood / 2);
        delay.least = std::max(delay.least, since - stood);
        delay.most = std::min(delay.most, since);
        delay.longestStood = std::max(delay.longestStood, stood);
    }
    return delay;
}

} // namespace autostereo::devices
