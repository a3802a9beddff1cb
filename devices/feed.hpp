#pragma once

#include "devices/frame.hpp"

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

namespace autostereo::devices {

/// in = paired + unpaired holds at every moment; frames still waiting for a partner are `pending`
/// and not yet in `in`. Unpaired includes frames that a full queue dropped.
struct StreamCounters {
    std::uint64_t in = 0;
    std::uint64_t paired = 0;
    std::uint64_t unpaired = 0;
    std::uint64_t pending = 0;
    std::uint64_t damaged = 0; ///< never entered: unreadable at the source
    std::uint64_t reconnects = 0;
};

struct FeedCounters {
    StreamCounters depth;
    StreamCounters color;
    std::uint64_t pairs = 0;   ///< formed
    std::uint64_t dropped = 0; ///< formed, but a newer pair was there when the consumer asked
};

/// The paired stream. Thread-bound to the consumer.
class Feed {
  public:
    virtual ~Feed() = default;
    /// The next pair, or nothing within `wait`. Never throws.
    [[nodiscard]] virtual std::optional<RgbdFrame>
    next(std::chrono::milliseconds wait) noexcept = 0;
    /// No pair will ever come again (end of a recording).
    [[nodiscard]] virtual bool ended() const noexcept = 0;
    [[nodiscard]] virtual FeedCounters counters() const noexcept = 0;
};

} // namespace autostereo::devices
