#pragma once

#include "devices/clock.hpp"

#include <condition_variable>
#include <cstdint>
#include <mutex>

namespace autostereo::devices {

/// Wakes one waiting thread when any of several others has something for it. Read `count` before
/// looking for work, then wait with it: a ring in between is not lost. Thread-safe.
class Doorbell {
  public:
    void ring() noexcept {
        {
            const std::scoped_lock lock(mutex_);
            ++count_;
        }
        rung_.notify_one();
    }

    [[nodiscard]] std::uint64_t count() const noexcept {
        const std::scoped_lock lock(mutex_);
        return count_;
    }

    /// Returns at the first ring after `seen`, or when `longest` is over.
    void wait(std::uint64_t seen, Duration longest) noexcept {
        std::unique_lock lock(mutex_);
        rung_.wait_for(lock, longest, [&] { return count_ != seen; });
    }

  private:
    mutable std::mutex mutex_;
    std::condition_variable rung_;
    std::uint64_t count_ = 0;
};

} // namespace autostereo::devices
