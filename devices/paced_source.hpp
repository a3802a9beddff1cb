#pragma once

#include "devices/input.hpp"
#include "devices/playback_epoch.hpp"
#include "devices/source.hpp"

#include <memory>

namespace autostereo::devices {

/// A recording as a live sensor: each frame comes out at host start + (its media time - the
/// recording's start), stamped with that host time. A reader that is late gets its frames at once
/// and none is skipped; dropping is the queue's business. In a loop it starts again, together with
/// the other streams of its epoch, with time and sequence going on. Thread-bound.
class PacedSource final : public Source {
  public:
    PacedSource(std::unique_ptr<Source> source, std::shared_ptr<PlaybackEpoch> epoch, Clock& clock,
                bool loop);

    [[nodiscard]] ReadResult read(TimePoint deadline) noexcept override;
    [[nodiscard]] bool rewind() noexcept override { return false; }
    [[nodiscard]] SourceCounters counters() const noexcept override { return source_->counters(); }

  private:
    void stamp(Frame& frame);
    [[nodiscard]] ReadResult release(TimePoint deadline);
    [[nodiscard]] ReadResult nextRound(TimePoint deadline);

    std::unique_ptr<Source> source_;
    std::shared_ptr<PlaybackEpoch> epoch_; // shared by streams that end on threads of their own
    Clock& clock_;
    bool loop_;
    Frame held_; ///< read, but not due yet
    TimePoint releaseAt_{};
    std::uint64_t firstSequence_ = 0; ///< of this round
    std::uint64_t nextSequence_ = 0;
    int round_ = 0;
    bool finished_ = false; ///< this round, and the epoch knows
};

/// The same input with both streams paced by one epoch.
[[nodiscard]] Input paced(Input input, Clock& clock, bool loop);

} // namespace autostereo::devices
