// A picture in the wrong view order is pseudoscopic while every number still looks fine. So each
// shipped display is looked at through its optics: an eye that moves right must see b rise.

#include "calib/panel_map.hpp"
#include "calib/phase_laws.hpp"
#include "config/load.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace autostereo::calib {
namespace {

/// b of the sub-pixel column k in row y.
double positionAt(const DisplayProfile& display, const ViewMap& map, int k, int y) {
    const std::uint32_t view = map.view(map.phase(k / 3, y, k % 3));
    return viewPosition(display, static_cast<int>(view));
}

/// Through a slit `gap` in front of the pixels (a lens does the same with more light) an eye sees
/// the place that its ray through the slit's centre meets: the eye goes right, that place left.
int columnSeen(double slit, double eye, double gap, double distance, double pitch) {
    return static_cast<int>(std::lround((slit - (eye - slit) * gap / distance) / pitch));
}

TEST(ViewOrder, AnEyeThatMovesRightSeesItsViewMoveRight) {
    int looked = 0;
    for (const std::string& name : config::displayNames()) {
        const DisplayProfile display = config::loadDisplay(name);
        const auto phase = affinePhase(display.law, display.views);
        if (!phase) continue; // no optics
        ++looked;
        SCOPED_TRACE(name);
        const ViewMap map = makeViewMap(display, display.width, display.height);
        const double pitch = display.widthM / (3 * display.width); // of sub-pixels
        const double lens = 3 * pitch / std::abs(phase->perColumn);
        const double eyes = display.viewingDistanceM * std::tan(display.coneRad / 2);
        // One lens period of pixels fans out over the cone.
        const double gap = lens / (2 * std::tan(display.coneRad / 2));
        for (int slit = 0; slit < 60; ++slit) {
            const int y = slit * 13;
            const double centre = (3 * 300 + slit * 7) * pitch;
            int rises = 0, falls = 0;
            double before = 0;
            for (int step = -50; step <= 50; ++step) {
                const double eye = centre + 0.98 * eyes * step / 50;
                const int k = columnSeen(centre, eye, gap, display.viewingDistanceM, pitch);
                const double b = positionAt(display, map, k, y);
                if (step > -50) {
                    rises += b > before;
                    falls += b < before;
                }
                before = b;
            }
            EXPECT_GE(rises, 3) << "slit " << slit;
            EXPECT_LE(falls, 1) << "slit " << slit; // where the fan begins anew
        }
    }
    EXPECT_EQ(looked, 3);
}

TEST(ViewOrder, PreviewsRedIsTheLeftEye) {
    const DisplayProfile display = config::loadDisplay("preview");
    const ViewMap map = makeViewMap(display, 64, 36);
    for (int x = 0; x < 64; ++x) {
        EXPECT_EQ(positionAt(display, map, 3 * x, x % 36), -1);
        EXPECT_EQ(positionAt(display, map, 3 * x + 1, x % 36), 1);
        EXPECT_EQ(positionAt(display, map, 3 * x + 2, x % 36), 1);
    }
}

} // namespace
} // namespace autostereo::calib
