#pragma once

#include "devices/frame.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <variant>

namespace autostereo::devices {

struct Timeout {};
struct Disconnected {
    std::string reason;
};
/// A recording is at its end; a live sensor never says so.
struct Ended {};

using ReadResult = std::variant<Frame, Timeout, Disconnected, Ended>;

struct SourceCounters {
    std::uint64_t delivered = 0;
    std::uint64_t damaged = 0; ///< unreadable, wrong size, failed to decode: dropped
    std::uint64_t starved = 0; ///< no free slot in the pool: dropped
};

/// One stream of one sensor, or of a recording. Thread-bound: `read` belongs to one thread.
/// Opening throws std::runtime_error; reading never throws and never blocks past its deadline
/// (a recording may ignore the deadline: it never waits).
class Source {
  public:
    virtual ~Source() = default;
    [[nodiscard]] virtual ReadResult read(TimePoint deadline) noexcept = 0;
    /// Back to the first frame (recordings and simulations); false where that cannot be.
    [[nodiscard]] virtual bool rewind() noexcept = 0;
    [[nodiscard]] virtual SourceCounters counters() const noexcept = 0;
};

/// Opens a sensor again; throws while it is not there. Empty: a lost sensor is an end.
using Reopen = std::function<std::unique_ptr<Source>()>;

} // namespace autostereo::devices
