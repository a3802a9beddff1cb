#include "calib/test_pattern.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace autostereo::calib {

namespace {

using Color = std::array<std::uint8_t, 3>;
constexpr Color kBlack{0, 0, 0}, kWhite{255, 255, 255};

/// Digits of 3 x 5 cells, a row a number, its bits from the left: 4, 2, 1.
constexpr std::array<std::array<unsigned, 5>, 10> kDigits{{{7, 5, 5, 5, 7},
                                                           {2, 6, 2, 2, 7},
                                                           {7, 1, 7, 4, 7},
                                                           {7, 1, 7, 1, 7},
                                                           {5, 5, 7, 1, 1},
                                                           {7, 4, 7, 1, 7},
                                                           {7, 4, 7, 5, 7},
                                                           {7, 1, 2, 2, 2},
                                                           {7, 5, 7, 5, 7},
                                                           {7, 5, 7, 1, 7}}};

std::uint8_t level(double share) {
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
}

/// Full saturation; hue 0 red, 1/3 green, 2/3 blue.
Color hue(double turn, double brightness) {
    const auto channel = [&](double peak) {
        double away = std::abs(turn - peak);
        away = std::min(away, 1 - away);
        return level(brightness * std::clamp(2 - 6 * away, 0.0, 1.0));
    };
    return {channel(0), channel(1.0 / 3), channel(2.0 / 3)};
}

/// Views' hues stop short of the circle, so that the two ends of the fan differ.
double hueOf(int view, int views) { return 0.8 * view / std::max(1, views - 1); }

bool inNumber(int number, double aspect, double u, double v) {
    const std::string digits = std::to_string(number);
    const double cells = 4 * static_cast<double>(digits.size()) - 1;
    // Half of the picture's height, or as much as its width leaves room for.
    const double cell = std::min(0.5 / 5, 0.8 * aspect / cells);
    const double x = ((u - 0.5) * aspect) / cell + cells / 2;
    const double y = (0.5 - v) / cell + 2.5;
    if (x < 0 || x >= cells || y < 0 || y >= 5) return false;
    const auto column = static_cast<std::size_t>(x);
    if (column % 4 == 3) return false;
    const auto digit = static_cast<std::size_t>(digits[column / 4] - '0');
    return (kDigits.at(digit).at(static_cast<std::size_t>(y)) >> (2 - column % 4) & 1U) != 0;
}

Color lines(int view, int views, double u, double v) {
    constexpr double kHalfWidth = 0.004;
    const bool onLine = std::abs(u - 0.5) < kHalfWidth || std::abs(v - 0.5) < kHalfWidth;
    const double offCentre = std::abs(2 * view + 1 - views) / 2.0; // views from the middle
    const std::uint8_t grey = level(onLine ? 1 - 0.5 * offCentre : 0);
    return {grey, grey, grey};
}

} // namespace

Color patternColor(TestPattern pattern, int view, int views, double aspect, double u, double v) {
    switch (pattern) {
    case TestPattern::Numbers:
        return inNumber(view, aspect, u, v) ? kWhite : hue(hueOf(view, views), 0.35);
    case TestPattern::Colors:
        return hue(hueOf(view, views), 1);
    case TestPattern::Lines:
        return lines(view, views, u, v);
    case TestPattern::Halves:
        return 2 * view + 1 > views ? kWhite : kBlack;
    case TestPattern::Ramps: {
        const std::uint8_t grey = level(view % 2 == 0 ? u : 1 - u);
        return {grey, grey, grey};
    }
    }
    return kBlack;
}

} // namespace autostereo::calib
