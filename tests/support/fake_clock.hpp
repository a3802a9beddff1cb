#pragma once

#include "devices/clock.hpp"

#include <atomic>

namespace autostereo::test {

/// A clock that moves only when told, or when somebody sleeps: sleeping takes no time. Thread-safe.
class FakeClock final : public devices::Clock {
  public:
    [[nodiscard]] devices::TimePoint now() const noexcept override {
        return devices::TimePoint(devices::Duration(now_.load()));
    }
    void sleepUntil(devices::TimePoint when) noexcept override {
        const auto target = when.time_since_epoch().count();
        auto seen = now_.load();
        while (seen < target && !now_.compare_exchange_weak(seen, target)) {
        }
    }
    void advance(devices::Duration by) { now_.fetch_add(by.count()); }

  private:
    std::atomic<devices::Duration::rep> now_{1'000'000'000'000};
};

} // namespace autostereo::test
