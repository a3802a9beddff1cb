#include "calib/band_map.hpp"
#include "tests/unit/calib/random_numbers.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace autostereo::calib {
namespace {

constexpr double kFoot = 0.3048, kDegree = 3.14159265358979323846 / 180;

/// Numbers of line screens that were built (rlk/electro's configuration files; feet and degrees).
/// Panels of the last two walls are not published: tiles of the first one's size.
struct Installation {
    const char* name;
    double linesPerFt, angleDeg, thicknessFt, shiftFt, dutyCycle;
    double widthFt;
    int width, height;
};
constexpr std::array kInstallations{
    Installation{"scylla", 271.945865, -7.69, 0.0336, 0.0102, 0.777777, 1.33, 1600, 1200},
    Installation{"tvarrier", 268.42671, -7.83, 0.0367, -0.0043, 0.75, 1.33, 1600, 1200},
    Installation{"personal", 266.67083, -7.572, 0.016, -0.00013, 0.8125, 2.1042, 2560, 1600},
    Installation{"personal, thin", 266.67083, -7.572, 0.0117, -0.0008, 0.8125, 2.1042, 2560, 1600},
    Installation{"another", 270.807188, -7.654, 0.0161, 0.00249, 0.777777, 2.1042, 2560, 1600},
    Installation{"vellum", 536.85342, -10.54, 0.0251, -0.0041, 0.75, 1.33, 1600, 1200},
    Installation{"interleaver", 300, -6.86, 0.00875, 0, 0.9, 1.20315, 1920, 1200},
};

DisplayProfile displayOf(const Installation& built, LineScreen::Form form) {
    DisplayProfile display;
    display.width = built.width;
    display.height = built.height;
    display.widthM = built.widthFt * kFoot;
    LineScreen screen;
    screen.linesPerM = built.linesPerFt / kFoot;
    screen.dutyCycle = built.dutyCycle;
    screen.thicknessM = built.thicknessFt * kFoot;
    screen.angleRad = built.angleDeg * kDegree;
    screen.shiftM = built.shiftFt * kFoot;
    screen.form = form;
    const double third = display.widthM / (3 * display.width);
    screen.subpixelOffsetsM = {-third, 0, third};
    display.law = screen;
    return display;
}

using Real = long double;
using Point = glm::vec<3, Real>;

Point subpixel(const DisplayProfile& display, int x, int y, int c) {
    const auto& screen = std::get<LineScreen>(display.law);
    const Real pixel = static_cast<Real>(display.widthM) / display.width;
    return {(x + Real{0.5} - display.width / Real{2}) * pixel +
                screen.subpixelOffsetsM.at(static_cast<std::size_t>(c)),
            (display.height / Real{2} - y - Real{0.5}) * pixel, 0};
}

/// From eye to sub-pixel until the barrier's plane; there, the distance from the line through
/// (shift, 0) that leans by the angle, in pitches.
Real byRay(const DisplayProfile& display, const glm::dvec3& eye, const Point& pixel) {
    const auto& screen = std::get<LineScreen>(display.law);
    const Point from(eye), towards = pixel - from;
    const Point hit = from + towards * ((screen.thicknessM - from.z) / towards.z);
    const Real angle = screen.angleRad;
    const Point along{std::sin(angle), std::cos(angle), 0}; // of the lines
    const Point foot{static_cast<Real>(screen.shiftM), 0, static_cast<Real>(screen.thicknessM)};
    return screen.linesPerM * glm::cross(hit - foot, along).z;
}

/// Section 3.2: scale p', rotate by a, translate by d - s'; 4 x 4, multiplied out.
Real byMatrices(const DisplayProfile& display, const glm::dvec3& eye, const Point& pixel) {
    using Matrix = glm::mat<4, 4, Real>;
    const auto& screen = std::get<LineScreen>(display.law);
    const Real t = screen.thicknessM, z = eye.z, reduction = (z - t) / z;
    const Real p = screen.linesPerM * reduction, s = screen.shiftM * reduction;
    const Matrix scale = glm::scale(Matrix(1), Point{p, p, 1});
    const Matrix turn = glm::rotate(Matrix(1), Real{screen.angleRad}, Point{0, 0, 1});
    const Matrix move = glm::translate(Matrix(1), Point{t * eye.x / z - s, t * eye.y / z, 0});
    return (scale * turn * move * glm::vec<4, Real>(pixel, 1)).x;
}

Real phaseAt(const LinearPhase& phase, int x, int y, int c) {
    return static_cast<Real>(phase.perColumn) * x + static_cast<Real>(phase.perRow) * y +
           phase.channels[0].at(static_cast<std::size_t>(c)) + phase.offset;
}

/// Largest difference, cycles, over all installations, seeded eyes and sub-pixels.
template<class Expected>
Real worstDifference(LineScreen::Form form, Expected expected) {
    Real worst = 0;
    RandomNumbers random(5);
    for (const Installation& built : kInstallations) {
        const DisplayProfile display = displayOf(built, form);
        for (int i = 0; i < 2000; ++i) {
            const glm::dvec3 eye{random.between(-1, 1), random.between(-0.6, 0.6),
                                 random.between(0.3, 3)};
            const int x = static_cast<int>(random.between(0, display.width));
            const int y = static_cast<int>(random.between(0, display.height)), c = i % 3;
            const LinearPhase phase = lineScreenPhase(std::get<LineScreen>(display.law), display,
                                                      display.width, display.height, eye);
            worst = std::max(worst, std::abs(phaseAt(phase, x, y, c) -
                                             expected(display, eye, subpixel(display, x, y, c))));
        }
    }
    return worst;
}

// 1e-9 cycle: the law's terms are doubles of some hundred cycles, good for 1e-13 each, times the
// columns.

TEST(LineScreenPhase, ExactIsWhereTheRayMeetsTheBarrier) {
    EXPECT_LT(worstDifference(LineScreen::Form::Exact, byRay), 1e-9);
}

TEST(LineScreenPhase, PaperIsTheMatrixOfSection32) {
    EXPECT_LT(worstDifference(LineScreen::Form::Paper, byMatrices), 1e-9);
}

/// Reducing pitch and shift after the parallax costs p t^2 v / v_z^2 and some of the shift.
TEST(LineScreenPhase, TheTwoFormsAreNotTheSame) {
    EXPECT_GT(worstDifference(LineScreen::Form::Paper, byRay), 0.01);
    EXPECT_GT(worstDifference(LineScreen::Form::Exact, byMatrices), 0.01);
}

TEST(TrackedLensPhase, IsTheDocumentedFormula) {
    RandomNumbers random(6);
    for (int i = 0; i < 2000; ++i) {
        TrackedLens lens;
        lens.periodPx = random.between(2, 20);
        lens.rowIncrementPx = random.between(-0.5, 0.5);
        lens.initPx = random.between(-20, 20);
        lens.fill = 0.3;
        lens.eyeGainPx = random.between(-3000, 3000);
        lens.zBiasM = random.between(-0.01, 0.01);
        const glm::dvec3 eye{random.between(-0.5, 0.5), random.between(-0.3, 0.3),
                             random.between(0.3, 2)};
        const int x = i, y = 3 * i % 1000, c = i % 3;
        const Real slant = lens.rowIncrementPx;
        const Real init = lens.initPx + lens.eyeGainPx * (eye.x + slant * eye.y) /
                                            (std::sqrt(1 + slant * slant) * (eye.z + lens.zBiasM));
        const Real expected = (x + c / Real{3} - slant * y - init) / lens.periodPx;
        EXPECT_NEAR(static_cast<double>(phaseAt(trackedLensPhase(lens, eye), x, y, c) - expected),
                    0, 1e-9);
    }
}

TEST(BandMap, LightsEachEyesBandWithinDutyCycleAndGuard) {
    DisplayProfile display = displayOf(kInstallations[2], LineScreen::Form::Exact);
    auto& screen = std::get<LineScreen>(display.law);
    screen.guard = 0.05;
    const glm::dvec3 eye{0.1, -0.05, 0.7};
    const BandMap map = bandMap(display, display.width, display.height, {eye});
    int lit = 0;
    for (int x = 0; x < display.width; ++x)
        for (int c = 0; c < 3; ++c) {
            const int y = x % display.height;
            const Real phase = byRay(display, eye, subpixel(display, x, y, c));
            const Real fraction = phase - std::floor(phase);
            const Real low = screen.dutyCycle + screen.guard / 2, high = 1 - screen.guard / 2;
            // Tables round to 2^-32 cycle.
            if (std::abs(fraction - low) < 1e-8 || std::abs(fraction - high) < 1e-8) continue;
            EXPECT_EQ(map.lit(0, x, y, c), fraction >= low && fraction < high) << x << ' ' << c;
            lit += map.lit(0, x, y, c) ? 1 : 0;
        }
    EXPECT_NEAR(lit, 3 * display.width * (1 - screen.dutyCycle - screen.guard), 40);
}

} // namespace
} // namespace autostereo::calib
