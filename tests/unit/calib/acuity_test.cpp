// What the eye of a tracked viewer reads through two line screens of real installations, one twice
// as fine as the other, where Kooima 2007 (section 4.2) had people read Snellen charts.

#include "calib/band_map.hpp"
#include "calib/light_field.hpp"
#include "calib/look.hpp"
#include "calib/srgb.hpp"
#include "config/load.hpp"
#include "tests/support/letter_chart.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>
#include <vector>

namespace autostereo::calib {
namespace {

using test::LetterChart;

constexpr double kDistanceM = 1.524; // 5 feet from the panel, in whose plane the chart is
constexpr glm::dvec3 kHalf{0.03175, 0, 0};
constexpr double kArcMinute = std::numbers::pi / (180 * 60);

/// A part of a panel of the chart's size, with its line screen, or without any.
class ChartDisplay {
  public:
    ChartDisplay(const char* profile, bool hasScreen) : display_(config::loadDisplay(profile)) {
        display_.widthM *= static_cast<double>(LetterChart::kSize) / display_.width;
        display_.width = display_.height = LetterChart::kSize;
        if (hasScreen) optics_ = displayOptics(display_);
    }

    [[nodiscard]] double pixelM() const { return display_.widthM / display_.width; }

    /// Luminance that the left eye sees of a picture which both eyes are shown.
    [[nodiscard]] std::vector<double> seen(const std::vector<double>& light,
                                           const glm::dvec3& head) const {
        if (!optics_) return light;
        const EyePicture eye =
            look(*optics_, {optics_->lenses.aperture, 0}, head - kHalf, panel(light, head));
        std::vector<double> luminance;
        for (std::size_t i = 0; i < eye.rgb.size(); i += 3)
            luminance.push_back(0.2126 * srgb_.light(eye.rgb[i]) +
                                0.7152 * srgb_.light(eye.rgb[i + 1]) +
                                0.0722 * srgb_.light(eye.rgb[i + 2]));
        return luminance;
    }

    /// How such a picture looks on this display on average over the places of its lines: look's
    /// tent, a line wide and as high as lines take to move by a pixel.
    [[nodiscard]] std::vector<double> expected(const std::vector<double>& light) const {
        if (!optics_) return light;
        const double perPixel = pixelM() * optics_->lenses.cyclesPerM(kDistanceM);
        LightField field(LetterChart::kSize, LetterChart::kSize);
        for (std::size_t i = 0; i < light.size(); ++i)
            field.values[i] = {light[i], 1};
        field.blur(static_cast<int>(std::lround(1 / perPixel)),
                   static_cast<int>(std::lround(1 / std::abs(optics_->lenses.slant))));
        std::vector<double> blurred;
        for (const glm::vec2& value : field.values)
            blurred.push_back(static_cast<double>(value.x) / static_cast<double>(value.y));
        return blurred;
    }

  private:
    /// The Combiner's panel.
    [[nodiscard]] std::vector<std::uint8_t> panel(const std::vector<double>& light,
                                                  const glm::dvec3& head) const {
        const BandMap map =
            bandMap(display_, display_.width, display_.height, {head - kHalf, head + kHalf});
        std::vector<std::uint8_t> levels;
        for (int y = 0; y < display_.height; ++y)
            for (int x = 0; x < display_.width; ++x)
                for (int c = 0; c < 3; ++c) {
                    const bool isLit = map.lit(0, x, y, c) || map.lit(1, x, y, c);
                    levels.push_back(isLit ? srgb_.level(light[levels.size() / 3]) : 0);
                }
        return levels;
    }

    DisplayProfile display_;
    std::optional<DisplayOptics> optics_;
    Srgb srgb_;
};

/// Of white's luminance, on each pixel of 0.57 arc minutes.
constexpr std::array<double, 3> kNoises{0.1, 0.3, 0.6};
using PerNoise = std::array<double, kNoises.size()>;

/// Share of letters of a size (arc minutes) that are named right.
PerNoise named(const ChartDisplay& display, double size) {
    constexpr int kCharts = 8;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> aside(-0.05, 0.05);
    PerNoise right{};
    for (int i = 0; i < kCharts; ++i) {
        const LetterChart chart(size * kArcMinute * kDistanceM / display.pixelM(), random);
        const std::vector<double> seen =
            display.seen(chart.light(0), {aside(random), aside(random), kDistanceM});
        std::array<std::vector<double>, 4> looks;
        for (int quarters = 0; quarters < 4; ++quarters)
            looks.at(static_cast<std::size_t>(quarters)) = display.expected(chart.light(quarters));
        for (std::size_t n = 0; n < kNoises.size(); ++n)
            right.at(n) += LetterChart::named(seen, looks, kNoises.at(n), random) /
                           static_cast<double>(kCharts * LetterChart::kLetters);
    }
    return right;
}

/// The smallest sizes from which on three letters of four are named right; 20/20 is 5.
PerNoise smallestRead(const ChartDisplay& display) {
    constexpr double kLargest = 13, kSmallest = 2.5, kStep = 1.1;
    PerNoise smallest;
    smallest.fill(0);
    for (double size = kLargest; size > kSmallest; size /= kStep) {
        const PerNoise right = named(display, size);
        for (std::size_t n = 0; n < kNoises.size(); ++n)
            if (right.at(n) < 0.75 && smallest.at(n) == 0) smallest.at(n) = size * kStep;
    }
    return smallest;
}

/// Sizes are 10 % apart, 128 letters each. Without a line screen the observer still reads letters
/// 1.3 times smaller than any read here: what is measured is the line screens.
TEST(Acuity, ALineScreenTwiceAsFineShowsFinerLetters) {
    const PerNoise one = smallestRead(ChartDisplay("varrier-scylla-tile", true));
    const PerNoise two = smallestRead(ChartDisplay("varrier-vellum-tile", true));
    const ChartDisplay plain("varrier-scylla-tile", false);
    for (std::size_t n = 0; n < kNoises.size(); ++n) {
        std::printf("noise %.1f: 272 lines a foot 20/%.0f, 537 lines 20/%.0f, %.2f times finer\n",
                    kNoises.at(n), 4 * one.at(n), 4 * two.at(n), one.at(n) / two.at(n));
        EXPECT_GT(two.at(n), 0);
        EXPECT_GE(one.at(n) / two.at(n), 1.3);
        EXPECT_GE(named(plain, two.at(n) / 1.3).at(n), 0.75);
    }
}

} // namespace
} // namespace autostereo::calib
