#pragma once

#include "calib/display_profile.hpp"

namespace autostereo::calib {

/// Numbers of a Looking Glass unit as its calibration file has them.
struct LookingGlassCalibration {
    double pitch = 0;  ///< lenses per inch, perpendicular to the lenses
    double slope = 0;  ///< pixels down per pixel sideways; the sign is the direction of the slant
    double center = 0; ///< phase offset in cycles
    double dpi = 0;
    int screenWidth = 0;
    int screenHeight = 0;
    bool flipImageX = false;
};

/// The vendor's published view formula (w = 1 - fract(a), view = floor(N w)) as a LinearPhase:
/// a falls out as A = -pitch'/W, B = +tilt pitch'/H (rows counted from the top).
[[nodiscard]] LinearPhase lookingGlassPhase(const LookingGlassCalibration& unit);

/// A slanted lens or slit over an RGB-stripe panel, in sub-pixels (van Berkel 1999; Eq. 11 of the
/// super-multi-view paper): view(k, l) = floor(N fract((k + offset - rowShift l) / X)).
struct VanBerkelLens {
    double subpixelsPerLens = 0;  ///< X
    double rowShiftSubpixels = 0; ///< 3 tan(alpha): the pattern moves right by this much per row
    double offsetSubpixels = 0;
};

/// Where X and the shifts are fractions of small whole numbers, sub-pixels lie exactly on the
/// boundaries of the N views; half of what phases and boundaries have in common is added, so that
/// none does and floor gives the view of the exact formula.
[[nodiscard]] LinearPhase vanBerkelPhase(const VanBerkelLens& lens, int views);

} // namespace autostereo::calib
