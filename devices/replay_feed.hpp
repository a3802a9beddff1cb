#pragma once

#include "devices/feed.hpp"
#include "devices/frame_sync.hpp"
#include "devices/input.hpp"
#include "devices/playback_epoch.hpp"

#include <memory>

namespace autostereo::devices {

/// A recording as fast as it can be consumed: no threads, no clock, nothing dropped, the same pairs
/// every time. Both streams are merged by media time; in a loop time and sequence go on. Takes both
/// sources of a complete input. Thread-bound.
class ReplayFeed final : public Feed {
  public:
    ReplayFeed(Input input, SyncParams sync, bool loop);

    /// Never waits. Nothing before `ended`: there were frames, but no pair yet; ask again.
    [[nodiscard]] std::optional<RgbdFrame> next(std::chrono::milliseconds wait) noexcept override;
    [[nodiscard]] bool ended() const noexcept override { return ended_; }
    [[nodiscard]] FeedCounters counters() const noexcept override;
    /// Recordings know no time: a stream is there until it ends.
    [[nodiscard]] SensorStatuses sensors() const override;
    [[nodiscard]] Frame takeColor() noexcept override { return sync_.takeColor(); }

  private:
    struct Stream {
        std::unique_ptr<Source> source;
        Frame head; ///< read, not merged yet
        bool ended = false;
        TimePoint last{};
        std::uint64_t firstSequence = 0; ///< of this round
        std::uint64_t nextSequence = 0;
    };

    [[nodiscard]] bool fill(Stream& stream);
    void merge();
    [[nodiscard]] bool startAgain();
    static void addUpstream(StreamCounters& counters, const Stream& stream);

    FrameSync sync_;
    PlaybackEpoch epoch_;
    Stream depth_;
    Stream color_;
    bool loop_;
    bool ended_ = false;
};

} // namespace autostereo::devices
