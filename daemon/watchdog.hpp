#pragma once

#include "devices/clock.hpp"

namespace autostereo::daemon {

/// The program's side of systemd's notify socket: says READY=1 when built, WATCHDOG=1 at half of
/// the time that the service manager allows while `pet` is called, STOPPING=1 at the end. Without
/// NOTIFY_SOCKET it does nothing; a notification that fails is no error of ours. Thread-bound.
class Watchdog {
  public:
    explicit Watchdog(devices::Clock& clock);
    ~Watchdog();
    Watchdog(const Watchdog&) = delete;
    Watchdog& operator=(const Watchdog&) = delete;

    /// Call at least every few frames, wherever the program proves that it is alive.
    void pet() noexcept;

  private:
    devices::Clock& clock_;
    devices::Duration interval_{0}; ///< 0: nobody watches
    devices::TimePoint last_;
};

} // namespace autostereo::daemon
