#pragma once

#include "devices/clock.hpp"

#include <cstddef>

namespace autostereo::devices {

/// Pairing of the two streams.
struct SyncParams {
    /// A depth and a colour frame whose mid-exposures lie further apart are no pair.
    Duration tolerance = std::chrono::milliseconds(20);
    /// The colour camera's stamps lie this far after the truth; taken off them.
    Duration colorLate{0};
};

/// The cameras' last pictures, kept in memory until somebody asks for them as a recording.
struct RingParams {
    Duration length{0};                              ///< 0: nothing is kept
    std::size_t mostBytes = std::size_t{256} << 20U; ///< of pictures

    [[nodiscard]] bool operator==(const RingParams&) const = default;
};

/// Reopening a sensor that went away.
struct ReconnectParams {
    Duration firstDelay = std::chrono::milliseconds(200);
    Duration longestDelay = std::chrono::milliseconds(500);
};

} // namespace autostereo::devices
