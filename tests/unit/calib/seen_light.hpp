#pragma once

#include "calib/lens_light.hpp"
#include "calib/phase_laws.hpp"
#include "calib/view_map.hpp"

#include <cmath>
#include <vector>

namespace autostereo::calib {

/// A sub-pixel that an eye sees something of.
struct SeenSubpixel {
    int x, y, c;
    double share;
};

/// Calls `each` for what an eye sees of some rows.
template<class Each>
void forSeen(const DisplayOptics& optics, const LightModel& light, const glm::dvec3& eye,
             const std::vector<int>& rows, Each each) {
    const int width = optics.subpixels.width;
    std::vector<double> shares(3 * static_cast<std::size_t>(width));
    for (const int y : rows) {
        seenShares(optics, light, eye, y, shares);
        for (std::size_t i = 0; i < shares.size(); ++i)
            if (shares[i] > 0)
                each(SeenSubpixel{static_cast<int>(i / 3), y, static_cast<int>(i % 3), shares[i]});
    }
}

/// Rows spread over the panel, symmetric about its middle.
inline std::vector<int> spreadRows(int height, int count) {
    std::vector<int> rows;
    for (int i = 0; i < count; ++i) {
        const int y = (2 * i + 1) * height / (4 * count);
        rows.push_back(y);
        rows.push_back(height - 1 - y);
    }
    return rows;
}

/// How the maker's phase runs over the panel, from the law and not from the optics: the test's own
/// source for the slant and the width of the lenses.
struct PanelSlopes {
    double perSubpixel = 0; ///< cycles
    double perRow = 0;      ///< downwards on the panel

    PanelSlopes(const DisplayProfile& display, const ViewMap& map) {
        const auto affine = affinePhase(display.law, display.views);
        perSubpixel =
            affine ? affine->perColumn / 3 : cycles(map.phase(0, 0, 1) - map.phase(0, 0, 0));
        perRow = affine ? affine->perRow : cycles(map.phase(0, 1, 0) - map.phase(0, 0, 0));
        if (map.upsideDown) perRow = -perRow;
    }

    [[nodiscard]] double subpixelsPerLens() const { return 1 / std::abs(perSubpixel); }
    /// dx/dy of lines of equal phase, y up.
    [[nodiscard]] double slant() const { return perRow / (3 * perSubpixel); }

  private:
    static double cycles(std::uint32_t step) {
        return std::ldexp(static_cast<double>(static_cast<std::int32_t>(step)), -32);
    }
};

/// The fan repeats: positions b and b + 2 are seen from the same place. To (-1, 1].
inline double wrapped(double positions) { return positions - 2 * std::round(positions / 2); }

} // namespace autostereo::calib
