#include "calib/panel_map.hpp"
#include "calib/phase_laws.hpp"
#include "tests/unit/calib/cycles.hpp"
#include "tests/unit/calib/random_numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace autostereo::calib {
namespace {

Real phaseOf(const LinearPhase& law, int x, int y, int c) {
    return static_cast<Real>(law.perColumn) * x + static_cast<Real>(law.perRow) * y +
           law.channels[0].at(static_cast<std::size_t>(c)) + law.offset;
}

/// The vendor's published formula as it stands: u, v at pixel centres, v counted from the bottom,
/// mirrored at the end.
Real vendorsViewShare(const LookingGlassCalibration& unit, int x, int y, int c) {
    const Real w = unit.screenWidth, h = unit.screenHeight;
    const Real mirror = unit.flipImageX ? -1 : 1;
    const Real pitch = unit.pitch * w / unit.dpi * std::cos(std::atan(1 / Real{unit.slope}));
    const Real tilt = h / (w * unit.slope) * mirror;
    const Real subpixel = 1 / (3 * w) * mirror;
    const Real u = (x + Real{0.5}) / w;
    const Real v = (h - 1 - y + Real{0.5}) / h;
    const Real a = (u + c * subpixel + v * tilt) * pitch - unit.center;
    return 1 - (a - std::floor(a));
}

// Published per-unit numbers: pitch, slope, centre, dpi, size. The third unit's sub-pixels do not
// lie in stripes; its numbers serve here, its cells are beyond this law.
LookingGlassCalibration unitWith(double pitch, double slope, double center, double dpi, int width,
                                 int height) {
    LookingGlassCalibration unit;
    unit.pitch = pitch;
    unit.slope = slope;
    unit.center = center;
    unit.dpi = dpi;
    unit.screenWidth = width;
    unit.screenHeight = height;
    return unit;
}

const std::vector kUnits{
    unitWith(52.56046553048362, -7.1423088016812, 0.47345216539737284, 324, 1536, 2048),
    unitWith(80.73520762926995, -6.62387594309422, 0.9212455662774963, 491, 1440, 2560),
    unitWith(44.74761962890625, -6.855094909667969, -0.26516956090927126, 283, 3840, 2160),
    unitWith(49.81804275512695, 5.044347763061523, 0.176902174949646, 338, 2560, 1600),
    unitWith(49.91, 5.8, 0, 338, 2560, 1600),
    unitWith(47.56401443481445, -5.480000019073486, 0.374184787273407, 338, 2560, 1600),
};

TEST(LookingGlassPhase, IsTheVendorsFormula) {
    for (LookingGlassCalibration unit : kUnits)
        for (const bool flipped : {false, true}) {
            unit.flipImageX = flipped;
            const LinearPhase law = lookingGlassPhase(unit);
            Real worst = 0;
            for (int y = 0; y < unit.screenHeight; y += 17)
                for (int x = 0; x < unit.screenWidth; x += 23)
                    for (int c = 0; c < 3; ++c)
                        worst = std::max(
                            worst, apart(phaseOf(law, x, y, c), vendorsViewShare(unit, x, y, c)));
            // Up to 900 cycles across the panel, each number rounded to double: 900 * 2^-53.
            EXPECT_LT(worst, 1e-12L) << "pitch " << unit.pitch << ", flipped " << flipped;
        }
}

TEST(LookingGlassPhase, GivesTheVendorsViews) {
    constexpr int kViews = 48;
    for (const LookingGlassCalibration& unit : kUnits) {
        DisplayProfile display;
        display.views = kViews;
        display.law = unit;
        const ViewMap map = makeViewMap(display, unit.screenWidth, unit.screenHeight);
        int wrong = 0, seen = 0;
        for (int y = 0; y < unit.screenHeight; y += 17)
            for (int x = 0; x < unit.screenWidth; x += 19)
                for (int c = 0; c < 3; ++c) {
                    const Real scaled = kViews * vendorsViewShare(unit, x, y, c);
                    // On a boundary the last bit decides: 2^-32 of phase is 1.2e-8 of a view.
                    if (std::abs(scaled - std::round(scaled)) < 2e-8L) continue;
                    ++seen;
                    wrong += map.view(map.phase(x, y, c)) != static_cast<std::uint32_t>(scaled);
                }
        EXPECT_EQ(wrong, 0) << "pitch " << unit.pitch;
        EXPECT_GT(seen, unit.screenWidth * unit.screenHeight / (17 * 19) * 3);
    }
}

/// Vendor's views of a whole panel: every sub-pixel that is not (a k - b y) mod n, k = 3x + c.
int differences(const DisplayProfile& display, int width, int height, int a, int b) {
    const ViewMap map = makeViewMap(display, width, height);
    const int n = display.views;
    int count = 0;
    for (int y = 0; y < height; ++y)
        for (int k = 0; k < 3 * width; ++k) {
            const int expected = ((a * k - b * y) % n + n) % n;
            count += map.view(map.phase(k / 3, y, k % 3)) != static_cast<std::uint32_t>(expected);
        }
    return count;
}

DisplayProfile lensSheet(int views, const VanBerkelLens& lens) {
    DisplayProfile display;
    display.views = views;
    display.law = lens;
    return display;
}

TEST(VanBerkelPhase, EightViewsLieAsTheVendorPrintsThem) {
    EXPECT_EQ(differences(lensSheet(8, {8, 1, 0}), 1920, 1080, 1, 1), 0);
}

TEST(VanBerkelPhase, FiveViewsLieOneSubpixelARow) {
    EXPECT_EQ(differences(lensSheet(5, {5, 1, 0}), 1600, 1200, 1, 1), 0);
    EXPECT_EQ(differences(lensSheet(5, {5, -1, 0}), 1600, 1200, 1, -1), 0);
}

TEST(VanBerkelPhase, GivesTheTablesOfDeSorbier2008) {
    const std::vector<std::vector<std::uint32_t>> slanted{
        {0, 2, 4}, {5, 1, 3}, {4, 0, 2}, {3, 5, 1}};
    const DisplayProfile display = lensSheet(6, {3, 0.5, 0});
    const ViewMap map = makeViewMap(display, 1, 4);
    for (int y = 0; y < 4; ++y)
        for (int c = 0; c < 3; ++c)
            EXPECT_EQ(map.view(map.phase(0, y, c)),
                      slanted[static_cast<std::size_t>(y)][static_cast<std::size_t>(c)])
                << "row " << y << ", channel " << c;
    EXPECT_EQ(differences(display, 1920, 1080, 2, 1), 0);
    // The normal one: upright lenses, 0 1 2 3 4 5 0 in every row.
    EXPECT_EQ(differences(lensSheet(6, {6, 0, 0}), 1920, 1080, 1, 0), 0);
}

TEST(VanBerkelPhase, RationalLensesHaveNoTies) {
    const VanBerkelLens lenses[] = {{8, 1, 0},     {5, -1, 2},    {3, 0.5, 0},     {6, 0, 0},
                                    {4.5, 0.5, 0}, {3.5, 1, 0.5}, {3, 1.0 / 3, 0}, {7, 1, 0.25}};
    for (const VanBerkelLens& lens : lenses)
        for (const int views : {1, 2, 5, 6, 7, 8, 9, 16, 28, 48}) {
            const LinearPhase law = vanBerkelPhase(lens, views);
            Real nearest = 1;
            for (int y = 0; y < 200; ++y)
                for (int k = 0; k < 300; ++k) {
                    const Real scaled = views * phaseOf(law, k / 3, y, k % 3);
                    nearest = std::min(nearest, std::abs(scaled - std::round(scaled)));
                }
            // Halfway between multiples of 1 / lcm(steps of the lens, views): never less than this.
            EXPECT_GT(nearest, 0.01L) << lens.subpixelsPerLens << ", shift "
                                      << lens.rowShiftSubpixels << ", " << views << " views";
        }
}

TEST(VanBerkelPhase, OtherLensesFollowTheFormula) {
    RandomNumbers random(6);
    for (int i = 0; i < 100; ++i) {
        const VanBerkelLens lens{random.between(3, 30), random.between(-2, 2),
                                 random.between(-20, 20)};
        const LinearPhase law = vanBerkelPhase(lens, 40);
        for (int sample = 0; sample < 100; ++sample) {
            const int x = static_cast<int>(random.between(0, 7680));
            const int y = static_cast<int>(random.between(0, 4320));
            const int c = sample % 3;
            const Real expected = (3 * x + c + static_cast<Real>(lens.offsetSubpixels) -
                                   static_cast<Real>(lens.rowShiftSubpixels) * y) /
                                  lens.subpixelsPerLens;
            // Up to 10,000 cycles, two numbers rounded to double: 10,000 * 2^-52.
            EXPECT_LT(apart(phaseOf(law, x, y, c), expected), 1e-11L);
        }
    }
}

} // namespace
} // namespace autostereo::calib
