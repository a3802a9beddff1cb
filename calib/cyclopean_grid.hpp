#pragma once

#include "calib/framing.hpp"

#include <glm/vec2.hpp>

namespace autostereo::calib {

/// The cyclopean view as a raster: it covers the panel and a margin around it, because views look
/// past the panel's edges. Texel centres at integers, row 0 on top.
struct CyclopeanGrid {
    int columns = 1;
    int rows = 1;
    double marginU = 0; ///< beyond either side, panel widths
    double marginV = 0; ///< above and below, panel heights
    [[nodiscard]] bool operator==(const CyclopeanGrid&) const = default;

    [[nodiscard]] glm::dvec2 panelFromTexel(const glm::dvec2& texel) const {
        return {(texel.x + 0.5) / columns * (1 + 2 * marginU) - marginU,
                1 + marginV - (texel.y + 0.5) / rows * (1 + 2 * marginV)};
    }
};

/// The grid over a framing with margins, with `density` texels per pixel of the depth camera, fewer
/// where that would be more than `mostTexels` in all.
[[nodiscard]] CyclopeanGrid cyclopeanGrid(const Framing& framing, const CameraModel& depth,
                                          double density, int mostTexels, double marginU,
                                          double marginV);

} // namespace autostereo::calib
