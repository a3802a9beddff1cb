#pragma once

#include "devices/frame_pool.hpp"
#include "devices/source.hpp"

#include <array>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace autostereo::devices {

/// One real stream handed out as two: its own frames and a companion made from each of them.
/// Whichever side is asked first reads the real source for both; what the other side has not
/// fetched waits here; of more than a few the oldest is dropped. Thread-safe, so both sides may be
/// read on threads of their own; the real source is never read by two at once.
class TwinStream {
  public:
    enum Side : std::size_t { Real = 0, Companion = 1 };
    /// Size and format of a companion, and how it is painted.
    struct Painter {
        std::function<FrameMetadata(const FrameMetadata& real)> describe;
        std::function<void(const Frame& real, Frame& companion)> paint;
    };

    /// `comesBack`: a lost real source is replaced; until then the companion waits.
    TwinStream(std::unique_ptr<Source> real, Painter painter, bool comesBack = false);

    [[nodiscard]] ReadResult read(Side side, TimePoint deadline);
    /// The real source is rewound when the first of both sides asks.
    [[nodiscard]] bool rewind(Side side);
    [[nodiscard]] SourceCounters counters(Side side) const;
    /// After the real side was told that the real source is gone; its counters start anew.
    void replace(std::unique_ptr<Source> real);

  private:
    struct Reader {
        std::deque<Frame> waiting;
        std::uint64_t handedOut = 0;
        std::uint64_t lost = 0; ///< no slot for it, or not fetched in time
        int round = 0;
    };

    [[nodiscard]] ReadResult readBoth(TimePoint deadline, std::unique_lock<std::mutex>& lock);
    static void keep(Reader& reader, std::optional<Frame> frame);

    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::unique_ptr<Source> source_;  ///< used by the thread that has set `reading_`; none: lost
    std::optional<std::string> lost_; ///< why; the real side has yet to be told
    bool comesBack_;
    Painter painter_;
    FramePool pool_{kFramesOnTheWay};
    std::array<Reader, 2> readers_;
    SourceCounters real_; ///< of the real source, after its last read
    int round_ = 0;
    bool reading_ = false;
    bool ended_ = false;
};

} // namespace autostereo::devices
