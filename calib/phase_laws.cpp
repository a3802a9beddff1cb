#include "calib/phase_laws.hpp"

#include <cmath>
#include <cstddef>

namespace autostereo::calib {

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

LinearPhase vanBerkelPhase(const VanBerkelLens& lens) {
    const double period = lens.subpixelsPerLens;
    LinearPhase phase;
    phase.perColumn = 3 / period;
    phase.perRow = -lens.rowShiftSubpixels / period;
    for (int c = 0; c < 3; ++c)
        phase.channel[static_cast<std::size_t>(c)] = c / period;
    phase.offset = lens.offsetSubpixels / period;
    const bool rational = period == std::floor(period) &&
                          lens.rowShiftSubpixels == std::floor(lens.rowShiftSubpixels) &&
                          lens.offsetSubpixels == std::floor(lens.offsetSubpixels);
    if (rational) phase.offset += 0.5 / period;
    return phase;
}

} // namespace autostereo::calib
