// A picture in the wrong view order is pseudoscopic while every number still looks fine. So each
// shipped display is looked at through its optics: an eye that moves right must see b rise.

#include "calib/panel_map.hpp"
#include "config/load.hpp"
#include "tests/unit/calib/shown_display.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace autostereo::calib {
namespace {

/// Light-weighted mean of what is seen; the fan repeats, so relative to what is expected.
double meanPosition(const ShownDisplay& shown, double b) {
    double light = 0, sum = 0;
    forSeen(shown.optics, {}, shown.eyeAt(b), spreadRows(shown.display.height, 12),
            [&](const SeenSubpixel& seen) {
                sum += seen.share * wrapped(shown.positionAt(seen) - b);
                light += seen.share;
            });
    EXPECT_GT(light, 0);
    return b + sum / light;
}

std::vector<ShownDisplay> shippedDisplays() {
    std::vector<ShownDisplay> found;
    for (const std::string& name : config::displayNames())
        if (auto shown = shownDisplay(config::loadDisplay(name)))
            found.push_back(std::move(*shown));
    return found;
}

TEST(ViewOrder, AnEyeThatMovesRightSeesItsViewMoveRight) {
    const auto all = shippedDisplays();
    EXPECT_GE(all.size(), 3U);
    for (const ShownDisplay& shipped : all) {
        SCOPED_TRACE(shipped.display.name);
        // Where lenses are whole sub-pixels wide, all have the same sub-pixel under their axis,
        // which may lie half its width to the side, and shows the middle of a view.
        const double views = shipped.display.views;
        const double coarsest = std::max(1 / views, 1 / shipped.slopes.subpixelsPerLens());
        double before = -2, first = 0;
        for (int step = -18; step <= 18; step += 3) {
            const double b = step / 20.0, seen = meanPosition(shipped, b);
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
    for (const ShownDisplay& shipped : shippedDisplays()) {
        SCOPED_TRACE(shipped.display.name);
        for (const glm::dvec3& eye :
             {glm::dvec3{0, 0, 1}, glm::dvec3{0, 0.15, 1}, glm::dvec3{0, -0.15, 1},
              glm::dvec3{0.1, 0.25, 1}, glm::dvec3{-0.15, -0.1, 1}, glm::dvec3{0.02, 0.03, 0.8},
              glm::dvec3{-0.03, -0.05, 1.25}, glm::dvec3{0.2, 0.3, 1.5}})
            EXPECT_LE(shipped.worstAt(eye * shipped.display.viewingDistanceM), shipped.mostAt())
                << eye.x << ' ' << eye.y << ' ' << eye.z;
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
