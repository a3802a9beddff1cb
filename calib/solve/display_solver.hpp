#pragma once

#include "calib/solve/panel_sight.hpp"

#include <span>
#include <string>
#include <vector>

namespace autostereo::calibrate {

/// A measured number in its file's own unit.
struct MeasuredNumber {
    std::string table, key;
    double value = 0;
    double half95 = 0; ///< half of the 95 % interval
};

struct DisplayCalibration {
    calib::DisplayProfile display; ///< what was assumed, with the measured numbers in it
    std::vector<MeasuredNumber> numbers;
    double rmsViews = 0;    ///< what the sights disagree by
    double half95Views = 0; ///< 95 % of the phase anywhere on the panel, views
    /// What these numbers cannot say, for the sheet is deformed: views, 95th percentile over the
    /// panel. From a twentieth of a view on it becomes the display's phase grid.
    double deformationViews = 0;
    double localViews = 0; ///< what is left then in sights that the grid was not made from, views
};

/// Pitch, slant, offset and fan of a display from what cameras in two places or more, apart from
/// side to side, saw of the fringes that `assumed` makes. Throws Refusal: too few places, sights
/// that disagree, a display whose numbers cannot be measured so, or one that is another model than
/// assumed (pitch off by more than 2 %, slant by more than a degree, fan by more than a quarter).
/// A pitch that is a whole multiple of the true one makes the same fringes from one place; how they
/// move from place to place tells it.
[[nodiscard]] DisplayCalibration calibrateDisplay(const calib::DisplayProfile& assumed,
                                                  std::span<const PanelSight> sights);

} // namespace autostereo::calibrate
