// A picture in the wrong view order is pseudoscopic while every number still looks fine. So each
// shipped display is looked at through its optics: an eye that moves right must see b rise.

#include "calib/panel_map.hpp"
#include "config/load.hpp"
#include "tests/unit/calib/seen_light.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace autostereo::calib {
namespace {

/// A shipped display with its optics and what its panel shows where.
struct Shipped {
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
    /// Light-weighted mean of what is seen; the fan repeats, so relative to what is expected.
    [[nodiscard]] double meanPosition(double b) const {
        double light = 0, sum = 0;
        forSeen(optics, {}, eyeAt(b), spreadRows(display.height, 12),
                [&](const SeenSubpixel& seen) {
                    sum += seen.share * wrapped(positionAt(seen) - b);
                    light += seen.share;
                });
        EXPECT_GT(light, 0);
        return b + sum / light;
    }
};

std::vector<Shipped> shippedDisplays() {
    std::vector<Shipped> found;
    for (const std::string& name : config::displayNames()) {
        const DisplayProfile display = config::loadDisplay(name);
        const auto optics = displayOptics(display);
        if (!optics || !display.remap.empty()) continue;
        const PanelMap map = panelMap(display, display.width, display.height);
        if (const auto* fixed = std::get_if<ViewMap>(&map))
            found.push_back({display, *optics, *fixed});
    }
    return found;
}

TEST(ViewOrder, AnEyeThatMovesRightSeesItsViewMoveRight) {
    const auto all = shippedDisplays();
    EXPECT_GE(all.size(), 3U);
    for (const Shipped& shipped : all) {
        SCOPED_TRACE(shipped.display.name);
        // Where lenses are whole sub-pixels wide, all have the same sub-pixel under their axis,
        // which may lie half its width to the side, and shows the middle of a view.
        const double views = shipped.display.views;
        const double coarsest = std::max(1 / views, 1 / shipped.slopes.subpixelsPerLens());
        double before = -2, first = 0;
        for (int step = -18; step <= 18; ++step) {
            const double b = step / 20.0, seen = shipped.meanPosition(b);
            EXPECT_NEAR(seen, b, coarsest + shipped.stretch() + 1e-6);
            EXPECT_GE(seen, before - 0.02 * coarsest) << b; // means of some 10,000 sub-pixels
            before = seen;
            if (step == -18) first = seen;
        }
        EXPECT_GT(before - first, 1.8 - 2 * coarsest);
    }
}

/// Everywhere on the panel and from anywhere, not only in the mean and on the nominal line.
TEST(ViewOrder, EverySubpixelIsSeenFromItsDirection) {
    for (const Shipped& shipped : shippedDisplays()) {
        SCOPED_TRACE(shipped.display.name);
        const double distance = shipped.display.viewingDistanceM;
        // Half a sub-pixel beside the axis, half a view beside its middle. 1 %: a sub-pixel covers
        // more or less of a lens from another distance.
        const double most = 1.01 / shipped.slopes.subpixelsPerLens() + 1.0 / shipped.display.views +
                            shipped.stretch() + 1e-6;
        for (const glm::dvec3& eye :
             {glm::dvec3{0, 0, 1}, glm::dvec3{0, 0.15, 1}, glm::dvec3{0, -0.15, 1},
              glm::dvec3{0.1, 0.25, 1}, glm::dvec3{-0.15, -0.1, 1}, glm::dvec3{0.02, 0.03, 0.8},
              glm::dvec3{-0.03, -0.05, 1.25}, glm::dvec3{0.2, 0.3, 1.5}}) {
            double worst = 0;
            forSeen(shipped.optics, {}, eye * distance, spreadRows(shipped.display.height, 12),
                    [&](const SeenSubpixel& seen) {
                        const glm::dvec2 place =
                            shipped.optics.subpixels.position(seen.x, seen.y, seen.c);
                        const double off =
                            shipped.positionAt(seen) - shipped.expectedAt(eye * distance, place);
                        worst = std::max(worst, std::abs(wrapped(off)));
                    });
            EXPECT_LE(worst, most) << eye.x << ' ' << eye.y << ' ' << eye.z;
        }
    }
}

TEST(ViewOrder, PreviewsRedIsTheLeftEye) {
    const DisplayProfile display = config::loadDisplay("preview");
    const ViewMap map = makeViewMap(display, 64, 36);
    const auto positionAt = [&](int x, int y, int c) {
        return viewPosition(display, static_cast<int>(map.view(map.phase(x, y, c))));
    };
    for (int x = 0; x < 64; ++x) {
        EXPECT_EQ(positionAt(x, x % 36, 0), -1);
        EXPECT_EQ(positionAt(x, x % 36, 1), 1);
        EXPECT_EQ(positionAt(x, x % 36, 2), 1);
    }
}

} // namespace
} // namespace autostereo::calib
