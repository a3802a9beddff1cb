#include "daemon/stop_signal.hpp"

#include <atomic>

namespace autostereo::daemon {

namespace {

// A handler can reach nothing but globals.
std::atomic<bool> stopRequested{false};
static_assert(std::atomic<bool>::is_always_lock_free);

} // namespace

StopSignal::StopSignal() {
    stopRequested = false;
    struct sigaction action {};
    action.sa_handler = onSignal;
    action.sa_flags = SA_RESTART;
    for (const int signal : kSignals)
        sigaddset(&action.sa_mask, signal);
    for (std::size_t i = 0; i < kSignals.size(); ++i)
        sigaction(kSignals[i], &action, &before_[i]);
}

StopSignal::~StopSignal() {
    for (std::size_t i = 0; i < kSignals.size(); ++i)
        sigaction(kSignals[i], &before_[i], nullptr);
}

bool StopSignal::requested() const noexcept { return stopRequested; }

void StopSignal::onSignal(int) {
    stopRequested = true;
    struct sigaction standard {};
    standard.sa_handler = SIG_DFL;
    for (const int signal : kSignals)
        sigaction(signal, &standard, nullptr);
}

} // namespace autostereo::daemon
