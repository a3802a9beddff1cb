#pragma once

#include "calib/solve/board_detector.hpp"

#include <cstdint>
#include <vector>

namespace autostereo::calibrate {

/// The picture in 8 bits: brightness as it is; amplitudes as square roots, their 99.9 % quantile
/// white, so that a highlight does not darken the rest.
[[nodiscard]] std::vector<std::uint8_t> greyPixels(const GreyImage& image);

} // namespace autostereo::calibrate
