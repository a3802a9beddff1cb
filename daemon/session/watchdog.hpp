#pragma once

#include "devices/clock.hpp"

namespace autostereo::daemon {

/// The program's side of systemd's notify socket: READY=1, then WATCHDOG=1 at half of the time
/// that the service manager allows while `pet` is called, STOPPING=1 at the end. Without
/// NOTIFY_SOCKET it does nothing; a notification that fails is no error of ours. Thread-bound.
class Watchdog {
  public:
    Watchdog();
    explicit Watchdog(devices::Clock& clock);

    /// The first picture can be drawn; the time of the first `pet` counts from here.
    void ready() noexcept;
    /// Call wherever the program proves that it is alive, at least every few frames.
    void pet() noexcept;
    void stopping() noexcept;

  private:
    devices::Clock& clock_;
    devices::Duration interval_{0}; ///< 0: nobody watches
    devices::TimePoint last_;
};

} // namespace autostereo::daemon
