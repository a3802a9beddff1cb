#pragma once

#include "devices/feed.hpp"
#include "devices/params.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace autostereo::devices {

/// Pairs each depth frame with the colour frame nearest to it in `capturedAt`, within the
/// tolerance; each frame is used at most once. Pure: no threads, and the time only as an argument.
/// A depth frame waits while a colour frame that is still to come could be nearer: at most half a
/// depth period from its arrival if it has a partner already, else until newer depth frames push
/// it out, so a stalled colour camera stops nobody. Time that steps back or wraps restarts a
/// stream; a time seen twice in a row is a duplicate. Both are counted as unpaired. Reentrant.
class FrameSync {
  public:
    static constexpr std::size_t kDepthKept = 4;
    static constexpr std::size_t kColorKept = 4;

    explicit FrameSync(SyncParams params) : params_(params) {}

    /// `arrivedAt` is on the clock of `next(now)`, which need not be that of `capturedAt`.
    void pushDepth(Frame frame, TimePoint arrivedAt = {});
    void pushColor(Frame frame);

    /// The oldest pair that nothing still to come can improve. Call until it gives nothing.
    [[nodiscard]] std::optional<RgbdFrame> next() { return decide(std::nullopt); }
    /// The same, and pairs that have waited long enough.
    [[nodiscard]] std::optional<RgbdFrame> next(TimePoint now) { return decide(now); }
    /// When `next(now)` will have a pair even though no further frame comes.
    [[nodiscard]] std::optional<TimePoint> ripeAt() const;

    /// The newest colour frame that waits; it and those before count as unpaired. Empty: none.
    [[nodiscard]] Frame takeColor();

    /// End of a recording: `next` settles everything that waits.
    void flush() { flushed_ = true; }

    /// Of both streams and the pairs; what happens before and after is for the feed to add.
    [[nodiscard]] FeedCounters counters() const;

  private:
    struct Waiting {
        Frame frame;
        TimePoint arrivedAt;
    };
    struct Stream {
        std::vector<Waiting> waiting; ///< oldest first
        std::optional<TimePoint> last;
        Duration step{0};    ///< between the last two frames, 0: unknown
        Duration spacing{0}; ///< likewise, but not across a frame that was lost
        std::uint64_t paired = 0;
        std::uint64_t unpaired = 0;

        void push(Frame frame, TimePoint arrivedAt, std::size_t limit);
        void discardOldest(std::size_t count);
        [[nodiscard]] Frame takeOldest();
        [[nodiscard]] StreamCounters counters() const;
    };

    [[nodiscard]] std::optional<RgbdFrame> decide(std::optional<TimePoint> now);
    [[nodiscard]] std::optional<std::size_t> nearestColor(TimePoint depthTime) const;
    [[nodiscard]] bool settled(TimePoint depthTime) const;
    [[nodiscard]] Duration grace(TimePoint depthTime, TimePoint partner) const;

    SyncParams params_;
    Stream depth_;
    Stream color_;
    std::uint64_t pairs_ = 0;
    bool flushed_ = false;
};

} // namespace autostereo::devices
