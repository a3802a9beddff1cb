#pragma once

#include "devices/clock.hpp"

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <utility>

namespace autostereo::devices {

/// One place for the newest of something big, handed on by exchange: nothing is copied, nothing
/// allocated once all parts have their size. Thread-safe.
template<class T>
class Latest {
  public:
    /// `value` becomes what lay here.
    void put(T& value) {
        {
            const std::lock_guard lock(mutex_);
            std::swap(value_, value);
            overwritten_ += fresh_ ? 1 : 0;
            fresh_ = true;
        }
        changed_.notify_one();
    }
    /// Waits until there is something new, or until `deadline` or `close`; false: nothing new.
    [[nodiscard]] bool take(T& value, TimePoint deadline) {
        std::unique_lock lock(mutex_);
        changed_.wait_until(lock, deadline, [&] { return fresh_ || closed_; });
        if (!fresh_) return false;
        std::swap(value_, value);
        fresh_ = false;
        return true;
    }
    /// Nothing will come any more.
    void close() {
        {
            const std::lock_guard lock(mutex_);
            closed_ = true;
        }
        changed_.notify_all();
    }
    /// How many nobody took in time.
    [[nodiscard]] std::uint64_t overwritten() const {
        const std::lock_guard lock(mutex_);
        return overwritten_;
    }

  private:
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    T value_{};
    bool fresh_ = false;
    bool closed_ = false;
    std::uint64_t overwritten_ = 0;
};

} // namespace autostereo::devices
