#include "calib/solve/display_numbers.hpp"

#include <cmath>
#include <numbers>

namespace autostereo::calibrate {

namespace {

constexpr double kDegree = std::numbers::pi / 180, kMm = 1e-3;

using Numbers = std::vector<DisplayNumber>;

/// A change in pitch that makes about one more fringe over a panel of so many pixels.
double pitchSpan(double pitch, int pixels) { return std::abs(pitch) / pixels; }

Numbers numbersOf(calib::LookingGlassCalibration& unit) {
    return {{"lens", "pitch", 1, pitchSpan(unit.pitch, unit.screenWidth), &unit.pitch},
            {"lens", "slope", 1, std::abs(unit.slope) / unit.screenHeight, &unit.slope},
            {"lens", "center", 1, 0.1, &unit.center}};
}

Numbers numbersOf(calib::VanBerkelLens& lens) {
    const double period = lens.subpixelsPerLens;
    return {{"lens", "subpixels_per_lens", 1, 1e-3 * period, &lens.subpixelsPerLens},
            {"lens", "row_shift_subpixels", 1, 1e-3 * period, &lens.rowShiftSubpixels},
            {"lens", "offset_subpixels", 1, 0.1 * period, &lens.offsetSubpixels}};
}

Numbers numbersOf(calib::CubeviCalibration& unit) {
    const double period = unit.subpixelsPerLens;
    return {{"lens", "subpixels_per_lens", 1, 1e-3 * period, &unit.subpixelsPerLens},
            {"lens", "slope", 1, 1e-3, &unit.slope},
            {"lens", "offset_subpixels", 1, 0.1 * period, &unit.offsetSubpixels}};
}

Numbers numbersOf(calib::LinearPhase& law) {
    return {{"lens", "per_column", 1, 1e-3, &law.perColumn},
            {"lens", "per_row", 1, 1e-3, &law.perRow},
            {"lens", "offset", 1, 0.1, &law.offset}};
}

Numbers numbersOf(calib::LineScreen& screen) {
    return {{"barrier", "lines_per_m", 1, 1e-3 * screen.linesPerM, &screen.linesPerM},
            {"barrier", "angle_deg", kDegree, 1e-3, &screen.angleRad},
            {"barrier", "shift_mm", kMm, 0.1 / screen.linesPerM, &screen.shiftM},
            {"barrier", "thickness_mm", kMm, 0.05 * screen.thicknessM, &screen.thicknessM}};
}

template<class Law>
Numbers numbersOf(Law& /*law*/) {
    return {};
}

} // namespace

std::vector<DisplayNumber> measuredNumbers(calib::DisplayProfile& display) {
    if (display.optics.kind == calib::Optics::Kind::None) return {};
    auto numbers = std::visit([](auto& law) { return numbersOf(law); }, display.law);
    if (numbers.size() != 3) return numbers;
    if (display.optics.gapM > 0)
        numbers.push_back(
            {"optics", "gap_mm", kMm, 0.05 * display.optics.gapM, &display.optics.gapM});
    else
        numbers.push_back(
            {"viewing", "cone_deg", kDegree, 0.05 * display.coneRad, &display.coneRad});
    return numbers;
}

} // namespace autostereo::calibrate
