#include "daemon/session/watchdog.hpp"

#include <chrono>
#include <cstdint>

#include <systemd/sd-daemon.h>

namespace autostereo::daemon {

namespace {

devices::Clock& hostClock() {
    static devices::SteadyClock clock;
    return clock;
}

} // namespace

Watchdog::Watchdog() : Watchdog(hostClock()) {}

Watchdog::Watchdog(devices::Clock& clock) : clock_(clock), last_(clock.now()) {
    std::uint64_t allowedUs = 0;
    if (sd_watchdog_enabled(0, &allowedUs) > 0)
        interval_ = std::chrono::microseconds(allowedUs / 2);
}

void Watchdog::ready() noexcept {
    last_ = clock_.now();
    sd_notify(0, "READY=1");
}

void Watchdog::pet() noexcept {
    if (interval_ == devices::Duration{0}) return;
    const devices::TimePoint now = clock_.now();
    if (now - last_ < interval_) return;
    last_ = now;
    sd_notify(0, "WATCHDOG=1");
}

void Watchdog::stopping() noexcept { sd_notify(0, "STOPPING=1"); }

} // namespace autostereo::daemon
