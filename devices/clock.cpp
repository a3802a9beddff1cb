#include "devices/clock.hpp"

#include <thread>

namespace autostereo::devices {

TimePoint SteadyClock::now() const noexcept { return std::chrono::steady_clock::now(); }

void SteadyClock::sleepUntil(TimePoint when) noexcept { std::this_thread::sleep_until(when); }

} // namespace autostereo::devices
