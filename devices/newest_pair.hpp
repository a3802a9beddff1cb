#pragma once

#include "devices/frame_queue.hpp"
#include "devices/frame_sync.hpp"

#include <cstdint>
#include <optional>

namespace autostereo::devices {

/// What lies between two sensors' threads and the consumer: a queue behind each sensor, and the
/// pairing. Never lags: of several pairs that are ready, the newest. A frame's wait for a better
/// partner counts from when it arrived, however late the consumer asks. Each queue has one writing
/// thread, everything else belongs to the consumer's; the time is an argument.
class NewestPair {
  public:
    using Queue = FrameQueue<Frame>;

    explicit NewestPair(SyncParams sync) : sync_(sync) {}

    [[nodiscard]] Queue& depth() { return depth_; }
    [[nodiscard]] Queue& color() { return color_; }

    /// Nothing: none is ready. `last`: no frame comes any more, what waits is settled.
    [[nodiscard]] std::optional<RgbdFrame> take(TimePoint now, bool last = false);
    /// When `take` will have a pair even though no further frame comes.
    [[nodiscard]] std::optional<TimePoint> ripeAt() const { return sync_.ripeAt(); }
    [[nodiscard]] Frame takeColor() { return sync_.takeColor(); }
    /// Without what the sources lost.
    [[nodiscard]] FeedCounters counters() const;

  private:
    void settle(std::optional<RgbdFrame>& newest, std::optional<TimePoint> now = {});

    Queue depth_, color_;
    FrameSync sync_;
    std::uint64_t dropped_ = 0;
};

} // namespace autostereo::devices
