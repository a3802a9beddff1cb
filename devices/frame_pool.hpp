#pragma once

#include "devices/frame.hpp"

#include <cstddef>
#include <optional>

namespace autostereo::devices {

/// Slots that a source needs so that a slow consumer never starves it: the queue, the pairing and
/// the consumer at their fullest, and a few for the source itself. Only slots in use cost memory.
inline constexpr std::size_t kFramesOnTheWay = 16;

/// Preallocated slots that Frames lease. `acquire` is called by the one thread that fills frames;
/// frames may be destroyed on any thread (lock-free), also after the pool: a sensor that is
/// reopened closes its old source while frames of it are still on their way. A slot grows when a
/// bigger frame is asked for and keeps its size, so a steady stream allocates nothing. Empty pool:
/// nothing, the caller drops its frame and counts it.
class FramePool final {
  public:
    explicit FramePool(std::size_t slots);
    ~FramePool();
    FramePool(const FramePool&) = delete;
    FramePool& operator=(const FramePool&) = delete;

    /// A frame with room for the pixels that `metadata` describes (its contents are undefined).
    [[nodiscard]] std::optional<Frame> acquire(const FrameMetadata& metadata);
    [[nodiscard]] std::size_t leased() const noexcept;

  private:
    class Slots; // lives until the pool and the last of its frames are gone
    Slots* slots_;
};

} // namespace autostereo::devices
