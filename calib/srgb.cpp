#include "calib/srgb.hpp"

#include <algorithm>
#include <cmath>

namespace autostereo::calib {

namespace {

/// The curve is steepest at the dark end: 12.92 x 255 levels per unit, 0.05 per step.
constexpr int kSteps = 65536;

double linear(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}
double encoded(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

} // namespace

Srgb::Srgb() {
    for (std::size_t level = 0; level < light_.size(); ++level)
        light_[level] = linear(static_cast<double>(level) / 255);
    levels_.reserve(kSteps + 1);
    for (int step = 0; step <= kSteps; ++step)
        levels_.push_back(static_cast<std::uint8_t>(
            std::lround(255 * encoded(static_cast<double>(step) / kSteps))));
}

std::uint8_t Srgb::level(double light) const {
    return levels_[static_cast<std::size_t>(std::lround(kSteps * std::clamp(light, 0.0, 1.0)))];
}

} // namespace autostereo::calib
