#include "calib/view_map.hpp"

#include <cmath>

namespace autostereo::calib {

namespace {

/// Cycles -> 2^-32 cycles, wrapping. Long double carries 64 bits of mantissa, so reducing a phase
/// of some thousand cycles loses nothing that 32 fractional bits could show.
std::uint32_t turns(long double cycles) {
    const long double fraction = cycles - std::floor(cycles);
    return static_cast<std::uint32_t>(
        static_cast<std::uint64_t>(std::llround(std::ldexp(fraction, 32))));
}

} // namespace

ViewMap makeViewMap(const DisplayProfile& display, int width, int height) {
    const LinearPhase& law = display.phase;
    ViewMap map;
    map.views = static_cast<std::uint32_t>(display.views);
    map.reversed = display.order == ViewOrder::RightToLeft;
    map.columns.reserve(3 * static_cast<std::size_t>(width));
    for (int x = 0; x < width; ++x)
        for (const double channel : law.channel)
            map.columns.push_back(turns(static_cast<long double>(law.perColumn) * x + channel));
    map.rows.reserve(static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y)
        map.rows.push_back(turns(static_cast<long double>(law.perRow) * y + law.offset));
    return map;
}

double viewPosition(const DisplayProfile& display, int view) {
    if (display.views == 1) return 0;
    if (display.fan == Fan::Edges) return 2.0 * view / (display.views - 1) - 1;
    return (2.0 * view + 1) / display.views - 1;
}

} // namespace autostereo::calib
