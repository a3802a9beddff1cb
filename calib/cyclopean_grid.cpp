#include "calib/cyclopean_grid.hpp"

#include <algorithm>
#include <cmath>

namespace autostereo::calib {

CyclopeanGrid cyclopeanGrid(const Framing& framing, const CameraModel& depth, double density,
                            double marginU, double marginV) {
    constexpr double kMost = 4096;
    const auto texels = [&](double extent, double focal, double margin) {
        const double wanted = std::round(extent * focal * density * (1 + 2 * margin));
        return static_cast<int>(std::clamp(wanted, 2.0, kMost));
    };
    return {texels(framing.width, depth.intrinsics.fx, marginU),
            texels(framing.height, depth.intrinsics.fy, marginV), marginU, marginV};
}

} // namespace autostereo::calib
