#pragma once

#include "calib/optics.hpp"
#include "calib/solve/panel_sight.hpp"

#include <glm/vec2.hpp>

#include <span>

namespace autostereo::calibrate {

/// How a sheet of lenses is deformed. Cycles.
struct SheetGrid {
    calib::PhaseGrid correction; ///< of the lenses' coordinate; empty: none is needed or none helps
    double deformed = 0;         ///< what sights see in common, 95th percentile over the panel
    double left = 0;    ///< 95th percentile of what a grid made from the others leaves in a sight
    double leftRms = 0; ///< the same, root of the mean square
};

/// From what is left of the fringes once `lenses` are fitted to them. A grid is made where the
/// deformation is `least` or more, where it explains a fifth of the variance in sights that it was
/// not made from (what the camera's own errors draw, moves with the camera), and up to a third of
/// a lens. `panelM`: the panel's width and height.
[[nodiscard]] SheetGrid fitSheetGrid(const calib::LensArray& lenses, const glm::dvec2& panelM,
                                     std::span<const PanelSight> sights, double least);

} // namespace autostereo::calibrate
