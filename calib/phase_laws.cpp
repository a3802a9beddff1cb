#include "calib/phase_laws.hpp"

#include <cmath>
#include <cstddef>
#include <numeric>

namespace autostereo::calib {

namespace {

bool whole(double number) { return std::abs(number - std::round(number)) < 1e-9; }

/// Phases of a rational lens are multiples of 1 / (this many) cycles; 0: not rational.
long stepsPerCycle(const VanBerkelLens& lens) {
    constexpr int kLargestDenominator = 64;
    for (int q = 1; q <= kLargestDenominator; ++q)
        if (whole(q * lens.subpixelsPerLens) && whole(q * lens.rowShiftSubpixels) &&
            whole(q * lens.offsetSubpixels))
            return std::lround(q * lens.subpixelsPerLens);
    return 0;
}

} // namespace

LinearPhase lookingGlassPhase(const LookingGlassCalibration& unit) {
    const double lensesPerWidth =
        unit.pitch * unit.screenWidth / unit.dpi * std::cos(std::atan(1 / unit.slope));
    const double mirror = unit.flipImageX ? -1 : 1;
    const double tilt = mirror * unit.screenHeight / (unit.screenWidth * unit.slope);
    const double subpixel = mirror / (3.0 * unit.screenWidth);

    // a(x, y_up, c) = (u + c subpixel + v tilt) pitch' - center with u, v at pixel centres and
    // v counted from the bottom; the vendor then mirrors, so phase = -a.
    LinearPhase phase;
    phase.perColumn = -lensesPerWidth / unit.screenWidth;
    phase.perRow = lensesPerWidth * tilt / unit.screenHeight;
    for (int c = 0; c < 3; ++c)
        phase.channel[static_cast<std::size_t>(c)] = -c * subpixel * lensesPerWidth;
    const double firstU = 0.5 / unit.screenWidth;
    const double firstV = (unit.screenHeight - 0.5) / unit.screenHeight;
    phase.offset = unit.center - (firstU + firstV * tilt) * lensesPerWidth;
    return phase;
}

LinearPhase vanBerkelPhase(const VanBerkelLens& lens, int views) {
    const double period = lens.subpixelsPerLens;
    LinearPhase phase;
    phase.perColumn = 3 / period;
    phase.perRow = -lens.rowShiftSubpixels / period;
    for (int c = 0; c < 3; ++c)
        phase.channel[static_cast<std::size_t>(c)] = c / period;
    phase.offset = lens.offsetSubpixels / period;
    if (const long steps = stepsPerCycle(lens); steps > 0)
        phase.offset += 0.5 / static_cast<double>(std::lcm(steps, long{views}));
    return phase;
}

} // namespace autostereo::calib
