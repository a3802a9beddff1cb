#pragma once

#include "devices/frame.hpp"

#include <chrono>

namespace autostereo::devices::sim {

/// The moment of a scene that a frame shows.
[[nodiscard]] inline double secondsOf(TimePoint capturedAt) {
    return std::chrono::duration<double>(capturedAt.time_since_epoch()).count();
}

/// Fills frames of one fixed shape. Thread-bound; what it draws is a pure function of the frame's
/// sequence number and time (`capturedAt`, from zero).
class SimulatedCamera {
  public:
    virtual ~SimulatedCamera() = default;
    [[nodiscard]] virtual FrameMetadata shape() const noexcept = 0;
    virtual void expose(Frame& frame) noexcept = 0;
};

} // namespace autostereo::devices::sim
