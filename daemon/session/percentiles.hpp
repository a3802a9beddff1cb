#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace autostereo::daemon {

/// Percentiles of the newest samples (a bounded ring): what it costs now, not since last month.
/// Thread-bound.
class Percentiles {
  public:
    void add(double sample) {
        if (samples_.size() < kKept) {
            samples_.push_back(sample);
            return;
        }
        samples_[next_] = sample;
        next_ = (next_ + 1) % kKept;
    }
    /// Nearest rank; `share` in [0, 1]. None without samples.
    [[nodiscard]] std::optional<double> at(double share) const {
        if (samples_.empty()) return std::nullopt;
        std::vector<double> sorted = samples_;
        const auto rank = std::lround(share * static_cast<double>(sorted.size() - 1));
        const auto place = sorted.begin() + rank;
        std::nth_element(sorted.begin(), place, sorted.end());
        return *place;
    }

  private:
    static constexpr std::size_t kKept = 4096;
    std::vector<double> samples_;
    std::size_t next_ = 0;
};

} // namespace autostereo::daemon
