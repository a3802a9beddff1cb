#include "daemon/reload_signal.hpp"

#include <atomic>

namespace autostereo::daemon {

namespace {

// A handler can reach nothing but globals.
std::atomic<bool> reloadRequested{false};
static_assert(std::atomic<bool>::is_always_lock_free);

} // namespace

ReloadSignal::ReloadSignal() {
    reloadRequested = false;
    struct sigaction action {};
    action.sa_handler = [](int) { reloadRequested = true; };
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    sigaction(SIGHUP, &action, &before_);
}

ReloadSignal::~ReloadSignal() { sigaction(SIGHUP, &before_, nullptr); }

bool ReloadSignal::take() const noexcept { return reloadRequested.exchange(false); }

} // namespace autostereo::daemon
