#pragma once

#include "calib/optics.hpp"

#include <span>

namespace autostereo::calib {

/// How much of a sub-pixel an eye sees, beyond where its rays go.
struct LightModel {
    double aperture = 0;  ///< width that is seen through a lens or slit, cycles, 0 to 1; 0: a line
    double crosstalk = 0; ///< share that leaks to either neighbour in the row, 0 to 1/3
};

/// Share of each sub-pixel of row y that the eye sees, 0 to 1, as [x][c] (3 x width numbers): how
/// much of the sub-pixel's width lies in the aperture of a lens or slit. With a line for an
/// aperture: 1 where the sub-pixel holds it (of two neighbours that it lies between, the right
/// one), else 0. Pure; reentrant; `eye.z` > max(gapM, 0).
void seenShares(const DisplayOptics& optics, const LightModel& light, const glm::dvec3& eye, int y,
                std::span<double> shares);

} // namespace autostereo::calib
