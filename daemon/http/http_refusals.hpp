#pragma once

#include <cstdint>
#include <map>
#include <mutex>

namespace autostereo::daemon {

/// Requests that were refused, by HTTP status (400 to 599). Thread-safe.
class HttpRefusals {
  public:
    using Counts = std::map<int, std::uint64_t>;

    void note(int status) {
        if (status < 400 || status > 599) return;
        const std::scoped_lock lock(mutex_);
        ++counts_[status];
    }
    [[nodiscard]] Counts counts() const {
        const std::scoped_lock lock(mutex_);
        return counts_;
    }

  private:
    mutable std::mutex mutex_;
    Counts counts_;
};

} // namespace autostereo::daemon
