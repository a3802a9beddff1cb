#pragma once

#include "calib/display_laws.hpp"

#include <optional>

// Vendors' formulas as one affine phase. Pure functions; reentrant.

namespace autostereo::calib {

/// The vendor's published view formula (w = 1 - fract(a), view = floor(N w)) as a LinearPhase:
/// a falls out as A = -pitch'/W, B = +tilt pitch'/H (rows counted from the top).
[[nodiscard]] LinearPhase lookingGlassPhase(const LookingGlassCalibration& unit);

/// Where X and the shifts are fractions of small whole numbers, sub-pixels lie exactly on the
/// boundaries of the N views; half of what phases and boundaries have in common is added, so that
/// none does and floor gives the view of the exact formula.
[[nodiscard]] LinearPhase vanBerkelPhase(const VanBerkelLens& lens, int views);

[[nodiscard]] LinearPhase cubeviPhase(const CubeviCalibration& unit);

/// The affine phase of those laws that have one for all eyes; nothing for the others.
[[nodiscard]] std::optional<LinearPhase> affinePhase(const DisplayLaw& law, int views);

} // namespace autostereo::calib
