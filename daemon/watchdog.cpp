#include "daemon/watchdog.hpp"

#include <chrono>
#include <cstdint>

#include <systemd/sd-daemon.h>

namespace autostereo::daemon {

Watchdog::Watchdog(devices::Clock& clock) : clock_(clock), last_(clock.now()) {
    std::uint64_t allowedUs = 0;
    if (sd_watchdog_enabled(0, &allowedUs) > 0)
        interval_ = std::chrono::microseconds(allowedUs / 2);
    sd_notify(0, "READY=1");
}

Watchdog::~Watchdog() { sd_notify(0, "STOPPING=1"); }

void Watchdog::pet() noexcept {
    if (interval_ == devices::Duration{0}) return;
    const devices::TimePoint now = clock_.now();
    if (now - last_ < interval_) return;
    last_ = now;
    sd_notify(0, "WATCHDOG=1");
}

} // namespace autostereo::daemon
