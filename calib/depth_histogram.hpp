#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace autostereo::calib {

/// Depths counted in bins of equal ratio (1.1 % wide), metres; what lies outside counts in the
/// outermost bins. Twin of binOf() in shaders/depth_statistics.comp.
class DepthHistogram {
  public:
    static constexpr double kNearestM = 0.05;
    static constexpr int kBinsPerOctave = 64;
    static constexpr std::size_t kBins = 704; ///< up to 102.4 m

    /// `counts`: kBins of them.
    explicit DepthHistogram(std::span<const std::uint32_t> counts);

    [[nodiscard]] static std::size_t binOf(double z);
    [[nodiscard]] std::uint64_t total() const { return total_; }
    /// Depth that `share` (0..1) of all lie before, interpolated within its bin; none where nothing
    /// was counted.
    [[nodiscard]] std::optional<double> quantile(double share) const;
    /// Share of all whose bin's middle lies between the two, ends included; 0 where nothing was
    /// counted.
    [[nodiscard]] double shareBetween(double nearM, double farM) const;
    /// Without what lies beyond `farM`.
    [[nodiscard]] DepthHistogram upTo(double farM) const;

  private:
    std::vector<std::uint32_t> counts_;
    std::uint64_t total_ = 0;
};

} // namespace autostereo::calib
