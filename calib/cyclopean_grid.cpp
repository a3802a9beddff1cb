#include "calib/cyclopean_grid.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace autostereo::calib {

CyclopeanGrid cyclopeanGrid(const Framing& framing, const CameraModel& depth, double density,
                            int mostTexels, double marginU, double marginV) {
    constexpr double kMostASide = 4096;
    const calib::Intrinsics& camera = depth.intrinsics;
    const auto [across, along] =
        framing.isSideways() ? std::pair(camera.fy, camera.fx) : std::pair(camera.fx, camera.fy);
    const double columns = framing.width * across * density * (1 + 2 * marginU);
    const double rows = framing.height * along * density * (1 + 2 * marginV);
    const double less = std::min(1.0, std::sqrt(mostTexels / (columns * rows)));
    const auto texels = [&](double wanted) {
        return static_cast<int>(std::clamp(std::floor(wanted * less), 2.0, kMostASide));
    };
    return {texels(columns), texels(rows), marginU, marginV};
}

} // namespace autostereo::calib
