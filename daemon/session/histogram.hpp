#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace autostereo::daemon {

/// How many latencies fell where, since the start. Thread-bound.
class Histogram {
  public:
    /// Upper ends of the bins, milliseconds, inclusive; one more bin takes what is beyond.
    static constexpr std::array<double, 14> kUpToMs{5,  10,  15,  20,  30,  40,  50,
                                                    75, 100, 150, 200, 300, 500, 1000};

    void add(double ms) {
        const auto bin = std::ranges::lower_bound(kUpToMs, ms) - kUpToMs.begin();
        ++counts_[static_cast<std::size_t>(bin)];
        sumMs_ += ms;
    }
    [[nodiscard]] const std::array<std::uint64_t, kUpToMs.size() + 1>& counts() const {
        return counts_;
    }
    [[nodiscard]] double sumMs() const { return sumMs_; }

  private:
    std::array<std::uint64_t, kUpToMs.size() + 1> counts_{};
    double sumMs_ = 0;
};

} // namespace autostereo::daemon
