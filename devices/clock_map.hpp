#pragma once

#include "devices/clock.hpp"

#include <optional>

namespace autostereo::devices {

/// A device's own clock on the host's: the delay between stamping and arrival varies, its minimum
/// does not, so the smallest difference seen is the offset between the clocks; it may creep up by
/// 100 us a second, so that clocks which drift apart stay mapped. A device clock that jumps starts
/// anew. Results never go back. Thread-bound.
class ClockMap {
  public:
    /// `device`: when the device stamped it, on its own clock. The result is never after `arrived`.
    [[nodiscard]] TimePoint map(Duration device, TimePoint arrived);

  private:
    struct Seen {
        Duration device;
        TimePoint arrived;
        Duration offset; ///< host minus device
        TimePoint result;
    };
    std::optional<Seen> last_;
};

} // namespace autostereo::devices
