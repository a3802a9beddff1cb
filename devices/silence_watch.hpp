#pragma once

#include "devices/clock.hpp"

namespace autostereo::devices {

/// When a camera has been silent for too long: drivers report nothing when frames stop coming. Two
/// seconds are given to the first frame, then five periods, of the negotiated rate or of the
/// exposure where that is longer. Every silence doubles the patience, up to two seconds, so that a
/// camera slower than it says is not restarted for ever. Thread-bound.
class SilenceWatch {
  public:
    /// The stream starts; `period` 0: not known.
    void start(TimePoint now, Duration period);
    void frame(TimePoint now, Duration exposure);
    /// From then on it is silent.
    [[nodiscard]] TimePoint deadline() const { return deadline_; }
    /// It was; call once per silence.
    void expired();

  private:
    Duration period_{0};
    int factor_ = 1;
    TimePoint deadline_{};
};

} // namespace autostereo::devices
