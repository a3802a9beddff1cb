#include "calib/phase_laws.hpp"

#include <cmath>
#include <numeric>
#include <utility>

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
    const double width = unit.screenWidth, height = unit.screenHeight;
    const double lensesPerWidth =
        unit.pitch * width / unit.dpi * std::cos(std::atan(1 / unit.slope));
    const double mirror = unit.flipImageX ? -1 : 1;
    const double tilt = mirror * height / (width * unit.slope);

    // a(x, y_up, c) = (u + v tilt) pitch' - center with u, v at pixel or sub-pixel centres and v
    // counted from the bottom; the vendor then mirrors, so phase = -a.
    const auto a = [&](double x, double yUp) {
        return (x / width + yUp / height * tilt) * lensesPerWidth;
    };
    LinearPhase phase;
    phase.perColumn = -a(1, 0);
    phase.perRow = unit.flipImageY ? -a(0, 1) : a(0, 1);
    phase.offset = unit.center - a(0.5, unit.flipImageY ? 0.5 : height - 0.5);
    phase.pattern = unit.pattern;
    phase.channels.clear();
    if (unit.cells.empty()) phase.channels.push_back({0, -a(mirror / 3, 0), -a(2 * mirror / 3, 0)});
    for (const SubpixelCell& cell : unit.cells)
        phase.channels.push_back(
            {-a(cell[0][0], cell[0][1]), -a(cell[1][0], cell[1][1]), -a(cell[2][0], cell[2][1])});
    if (unit.flipSubpixels)
        for (auto& channels : phase.channels)
            std::swap(channels[0], channels[2]);
    phase.grid = unit.grid;
    return phase;
}

LinearPhase vanBerkelPhase(const VanBerkelLens& lens, int views) {
    const double period = lens.subpixelsPerLens;
    LinearPhase phase;
    phase.perColumn = 3 / period;
    phase.perRow = -lens.rowShiftSubpixels / period;
    phase.channels = {{0, 1 / period, 2 / period}};
    if (lens.bgr) std::swap(phase.channels[0][0], phase.channels[0][2]);
    phase.offset = lens.offsetSubpixels / period;
    if (const long steps = stepsPerCycle(lens); steps > 0)
        phase.offset += 0.5 / static_cast<double>(std::lcm(steps, long{views}));
    phase.grid = lens.grid;
    return phase;
}

LinearPhase cubeviPhase(const CubeviCalibration& unit) {
    const double period = unit.subpixelsPerLens;
    LinearPhase phase;
    phase.perColumn = 3 / period;
    phase.perRow = 3 * unit.slope / period;
    phase.channels = {{0, 1 / period, 2 / period}};
    phase.offset = (3 * (1 + unit.slope) + unit.offsetSubpixels) / period; // counts from 1
    phase.grid = unit.grid;
    return phase;
}

std::optional<LinearPhase> affinePhase(const DisplayLaw& law, int views) {
    if (const auto* linear = std::get_if<LinearPhase>(&law)) return *linear;
    if (const auto* lens = std::get_if<VanBerkelLens>(&law)) return vanBerkelPhase(*lens, views);
    if (const auto* unit = std::get_if<LookingGlassCalibration>(&law))
        return lookingGlassPhase(*unit);
    if (const auto* unit = std::get_if<CubeviCalibration>(&law)) return cubeviPhase(*unit);
    return std::nullopt;
}

} // namespace autostereo::calib
