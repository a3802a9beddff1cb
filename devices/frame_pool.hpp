#pragma once

#include "devices/frame.hpp"

#include <atomic>
#include <cstddef>
#include <optional>
#include <vector>

namespace autostereo::devices {

/// Preallocated slots that Frames lease. `acquire` is called by the one thread that fills frames;
/// frames may be destroyed on any thread (lock-free). A slot grows when a bigger frame is asked
/// for and keeps its size, so a steady stream allocates nothing. Empty pool: nothing, the caller
/// drops its frame and counts it.
class FramePool final : public Frame::Owner {
  public:
    explicit FramePool(std::size_t slots);
    ~FramePool();
    FramePool(const FramePool&) = delete;
    FramePool& operator=(const FramePool&) = delete;

    /// A frame with room for the pixels that `metadata` describes (its contents are undefined).
    [[nodiscard]] std::optional<Frame> acquire(const FrameMetadata& metadata);
    [[nodiscard]] std::size_t leased() const noexcept;

  private:
    void release(std::size_t slot) noexcept override;

    struct Slot {
        std::atomic<bool> busy{false};
        std::vector<std::max_align_t> storage;
    };
    std::vector<Slot> slots_;
};

} // namespace autostereo::devices
