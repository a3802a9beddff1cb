#pragma once

#include <cstdint>
#include <optional>

namespace autostereo::devices {

/// A driver's 32-bit frame numbers, which wrap and sometimes start again -> numbers that only rise.
/// A small step forward is frames that were lost on the way; anything else counts as the next one.
class SequenceCounter {
  public:
    /// The first is `first`.
    explicit SequenceCounter(std::uint64_t first = 0) : next_(first) {}

    [[nodiscard]] std::uint64_t map(std::uint32_t number) {
        constexpr std::uint32_t kMostLost = 1000;
        if (last_) {
            const std::uint32_t step = number - *last_; // wraps with them
            if (step > 1 && step <= kMostLost) {
                lost_ += step - 1;
                next_ += step - 1;
            }
        }
        last_ = number;
        return next_++;
    }
    [[nodiscard]] std::uint64_t lost() const { return lost_; }

  private:
    std::optional<std::uint32_t> last_;
    std::uint64_t next_;
    std::uint64_t lost_ = 0;
};

} // namespace autostereo::devices
