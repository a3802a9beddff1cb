#pragma once

#include "devices/clock.hpp"

#include <mutex>

namespace autostereo::devices {

/// Where the media time of a recording lies on the consumer's time line, for all of its streams
/// together; moved on when the recording is played again. Thread-safe.
class PlaybackEpoch {
  public:
    /// `mediaStart`: first frame of the recording. `period`: between frames, 0: unknown.
    PlaybackEpoch(TimePoint mediaStart, Duration period, int streams);

    /// Media start comes at `origin`; the first call counts.
    void start(TimePoint origin);
    /// Damaged time stamps are kept within a month of the start, so that sums cannot overflow.
    [[nodiscard]] TimePoint timeOf(TimePoint media) const;

    /// A stream's last frame came at `last`; each stream says so once a round. When all have, the
    /// next round begins, one period after the latest of them.
    void finish(TimePoint last);
    [[nodiscard]] int round() const;

  private:
    mutable std::mutex mutex_;
    const TimePoint mediaStart_;
    const Duration period_;
    const int streams_;
    TimePoint origin_{};
    bool started_ = false;
    TimePoint latest_{}; ///< end of the streams that have finished this round
    int finished_ = 0;
    int round_ = 0;
};

} // namespace autostereo::devices
