#pragma once

#include "devices/clock.hpp"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <optional>

namespace autostereo::daemon {

/// Lets through so many a second, and as many at once after a second of rest. Thread-safe.
class RateLimit {
  public:
    explicit RateLimit(double perSecond) : perSecond_(perSecond), left_(perSecond) {}

    /// Whether one more may pass at `now`, which never goes back.
    [[nodiscard]] bool pass(devices::TimePoint now) {
        const std::scoped_lock lock(mutex_);
        if (last_) {
            const double rested = std::chrono::duration<double>(now - *last_).count();
            left_ = std::min(perSecond_, left_ + std::max(0.0, rested) * perSecond_);
        }
        last_ = now;
        if (left_ < 1) return false;
        left_ -= 1;
        return true;
    }

  private:
    double perSecond_;
    std::mutex mutex_; ///< of what follows
    double left_;
    std::optional<devices::TimePoint> last_;
};

} // namespace autostereo::daemon
