#pragma once

#include "devices/clock_map.hpp"

#include <cstdint>
#include <optional>

namespace autostereo::devices::kinect2 {

/// One camera's clock (units of 0.125 ms, 32 bits, wraps) -> the host's. Depth frames, which leave
/// the camera as they are taken, tie the two together; colour pictures, which wait to be
/// compressed, follow by the camera's own clock. What a stamp marks is not documented; the end of
/// the exposure is assumed for both. Thread-bound.
class UnitClock {
  public:
    /// Middle of the exposure of a depth frame that was complete at `arrived`.
    [[nodiscard]] TimePoint depth(std::uint32_t stamp, TimePoint arrived);
    /// The same of a colour picture that was exposed for so long; never after `arrived`.
    [[nodiscard]] TimePoint color(std::uint32_t stamp, float exposureMs, TimePoint arrived) const;

  private:
    struct Tie {
        std::uint32_t stamp;
        Duration device; ///< without wraps
        TimePoint host;
    };
    ClockMap map_;
    std::optional<Tie> tie_;
};

} // namespace autostereo::devices::kinect2
