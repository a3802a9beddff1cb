#pragma once

#include "calib/panel_map.hpp"
#include "tests/unit/calib/seen_light.hpp"

#include <algorithm>
#include <optional>

namespace autostereo::calib {

/// A display with its optics and what its panel shows where.
struct ShownDisplay {
    DisplayProfile display;
    DisplayOptics optics;
    ViewMap map;
    PanelSlopes slopes{display, map};

    [[nodiscard]] double positionAt(const SeenSubpixel& seen) const {
        const std::uint32_t view = map.view(map.phase(seen.x, seen.y, seen.c));
        return viewPosition(display, static_cast<int>(view));
    }
    /// What an eye at `eye` should see at a place: its direction from there, less the direction of
    /// the nominal place, as a share of the fan. Along the lenses nothing changes, so that height
    /// acts as a shift by -slant.
    [[nodiscard]] double expectedAt(const glm::dvec3& eye, const glm::dvec2& place) const {
        const auto across = [&](double x, double y) { return x - slopes.slant() * y; };
        const double direction = across(eye.x - place.x, eye.y - place.y) / eye.z;
        const double nominal = across(-place.x, -place.y) / display.viewingDistanceM;
        return (direction - nominal) / std::tan(display.coneRad / 2);
    }
    /// b of the eye on the nominal line.
    [[nodiscard]] glm::dvec3 eyeAt(double b) const {
        const double distance = display.viewingDistanceM;
        return {b * distance * std::tan(display.coneRad / 2), 0, distance};
    }
    /// Fans whose outermost cameras are at +-1 stretch the views' middles to there.
    [[nodiscard]] double stretch() const {
        return display.fan == Fan::Edges ? 1.0 / (display.views - 1) : 0;
    }
    /// How far what an eye sees anywhere lies beside what it should see there, at worst.
    [[nodiscard]] double worstAt(const glm::dvec3& eye) const {
        double worst = 0;
        forSeen(optics, {}, eye, spreadRows(display.height, 12), [&](const SeenSubpixel& seen) {
            const glm::dvec2 place = optics.subpixels.position(seen.x, seen.y, seen.c);
            const double off = positionAt(seen) - expectedAt(eye, place);
            worst = std::max(worst, std::abs(wrapped(off)));
        });
        return worst;
    }
    /// The most it may be: half a sub-pixel beside the axis, half a view beside its middle. 1 %: a
    /// sub-pixel covers more or less of a lens from another distance.
    [[nodiscard]] double mostAt() const {
        return 1.01 / slopes.subpixelsPerLens() + 1.0 / display.views + stretch() + 1e-6;
    }
};

/// Nothing for displays without optics, tracked ones, and those that show views twice.
inline std::optional<ShownDisplay> shownDisplay(const DisplayProfile& display) {
    const auto optics = displayOptics(display);
    if (!optics || !display.remap.empty()) return std::nullopt;
    const PanelMap map = panelMap(display, display.width, display.height);
    const auto* fixed = std::get_if<ViewMap>(&map);
    if (fixed == nullptr) return std::nullopt;
    return ShownDisplay{display, *optics, *fixed};
}

} // namespace autostereo::calib
