#include "calib/solve/grey_pixels.hpp"

#include <algorithm>
#include <cmath>

namespace autostereo::calibrate {

namespace {

double quantile(std::span<const std::uint16_t> values, double share) {
    std::vector<std::uint16_t> sorted(values.begin(), values.end());
    const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(sorted.size() - 1));
    std::nth_element(sorted.begin(), sorted.begin() + place, sorted.end());
    return sorted[static_cast<std::size_t>(place)];
}

} // namespace

std::vector<std::uint8_t> greyPixels(const GreyImage& image) {
    constexpr double kWhiteShare = 0.999;
    constexpr double kWhite = 255;
    std::vector<std::uint8_t> grey;
    grey.reserve(image.values.size());
    const double white =
        image.isInfrared && !image.values.empty() ? quantile(image.values, kWhiteShare) : kWhite;
    for (const std::uint16_t value : image.values) {
        const double share = std::min(1.0, value / std::fmax(white, 1));
        const double level = image.isInfrared ? std::sqrt(share) : share;
        grey.push_back(static_cast<std::uint8_t>(std::lround(kWhite * level)));
    }
    return grey;
}

} // namespace autostereo::calibrate
