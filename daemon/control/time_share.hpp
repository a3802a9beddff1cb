#pragma once

#include "devices/clock.hpp"

namespace autostereo::daemon {

/// Lets something that is not the program's purpose have a share of a thread's time: after it took
/// so long, it rests until that was no more than its share. Thread-bound.
class TimeShare {
  public:
    /// `rest`: times as long as it took.
    explicit TimeShare(int rest) : rest_(rest) {}

    [[nodiscard]] bool isFree(devices::TimePoint now) const { return now >= freeAt_; }
    void used(devices::TimePoint start, devices::TimePoint end) {
        freeAt_ = end + rest_ * (end - start);
    }

  private:
    int rest_;
    devices::TimePoint freeAt_{};
};

} // namespace autostereo::daemon
