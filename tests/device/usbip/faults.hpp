#pragma once

#include <cstdint>
#include <optional>

namespace autostereo::test::usbip {

/// What goes wrong on the wire of one endpoint. A packet is a bulk or interrupt transfer, or one
/// interval of an isochronous one. Shares are probabilities, 0 to 1.
struct Faults {
    double lose = 0;      ///< isochronous: EXDEV and no data; bulk: EPROTO and no data
    double truncate = 0;  ///< the second half is missing
    double duplicate = 0; ///< comes twice; the next one is not asked for
    double reorder = 0;   ///< changes places with the next one
    bool stall = false;   ///< EPIPE, until the fault is lifted
    bool silent = false;  ///< no transfer ends any more
    /// After so many more packets the device is gone.
    std::optional<std::uint64_t> unplugAfter{};
    bool babble = false; ///< sends more than it was asked for: EOVERFLOW, as host controllers say
};

} // namespace autostereo::test::usbip
