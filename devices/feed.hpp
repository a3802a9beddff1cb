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

/// Of two feeds one after the other; what is pending is the second's.
[[nodiscard]] inline FeedCounters sum(const FeedCounters& first, const FeedCounters& second) {
    const auto stream = [](StreamCounters a, const StreamCounters& b) {
        a.in += b.in;
        a.paired += b.paired;
        a.unpaired += b.unpaired;
        a.pending = b.pending;
        a.damaged += b.damaged;
        a.reconnects += b.reconnects;
        return a;
    };
    return {stream(first.depth, second.depth), stream(first.color, second.color),
            first.pairs + second.pairs, first.dropped + second.dropped};
}

/// What became of a sensor.
enum class SensorState {
    Starting,  ///< open, no frame yet
    Streaming, ///< gave frames since it was opened; how long ago says `lastFrame`
    Lost,      ///< gone or silent for too long; it is being opened again
    Ended      ///< the end of a recording, or lost for good
};
struct SensorStatus {
    SensorState state = SensorState::Starting;
    std::optional<TimePoint> lastFrame; ///< when it came, on the feed's clock
    std::string reason;                 ///< of the last loss; empty: there was none
};
struct SensorStatuses {
    SensorStatus depth;
    SensorStatus color;
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
    [[nodiscard]] virtual SensorStatuses sensors() const = 0;
    /// The newest colour frame that waits for a depth frame, and now will not get one; empty: none.
    [[nodiscard]] virtual Frame takeColor() noexcept = 0;
};

} // namespace autostereo::devices
