#pragma once

#include <chrono>

namespace autostereo::devices {

/// Host CLOCK_MONOTONIC in nanoseconds. Recordings played at full speed use their own media time
/// in the same type, counted from zero.
using TimePoint = std::chrono::time_point<std::chrono::steady_clock, std::chrono::nanoseconds>;
using Duration = std::chrono::nanoseconds;

/// For what deals with hardware, whose times no test can make up.
[[nodiscard]] inline TimePoint steadyNow() noexcept { return std::chrono::steady_clock::now(); }

/// The only other way to ask for the time or to wait, so that tests never sleep. Thread-safe.
class Clock {
  public:
    virtual ~Clock() = default;
    [[nodiscard]] virtual TimePoint now() const noexcept = 0;
    virtual void sleepUntil(TimePoint when) noexcept = 0;
};

class SteadyClock final : public Clock {
  public:
    [[nodiscard]] TimePoint now() const noexcept override;
    void sleepUntil(TimePoint when) noexcept override;
};

} // namespace autostereo::devices
