#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace autostereo::calib {

/// Pictures' numbers to shares of full light and back (IEC 61966-2-1). Tables: rounding costs less
/// than 0.05 of a level, and every level comes back as itself. Reentrant once built.
class Srgb {
  public:
    Srgb();
    [[nodiscard]] double light(std::uint8_t level) const { return light_[level]; }
    /// Clamped to [0, 1].
    [[nodiscard]] std::uint8_t level(double light) const;

  private:
    std::array<double, 256> light_{};
    std::vector<std::uint8_t> levels_;
};

} // namespace autostereo::calib
