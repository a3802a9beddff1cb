#include "daemon/commands/plain_display.hpp"

#include <algorithm>
#include <cmath>

namespace autostereo::daemon {

namespace {

/// A narrower fan: disparities are told at its end, so that they shrink with it.
void spanTwoEyes(calib::DisplayProfile& display) {
    constexpr double kHalfEyeDistanceM = 0.0315;
    const double before = std::tan(display.coneRad / 2);
    const double tangent = kHalfEyeDistanceM / display.viewingDistanceM;
    display.coneRad = 2 * std::atan(tangent);
    display.disparityFar *= tangent / before;
    display.disparityNear *= tangent / before;
    display.views = 2;
    display.fan = calib::Fan::Edges;
}

/// Grey uses its whole range for the display's budget.
calib::DepthFrame depthFrame(const calib::DisplayProfile& display) {
    constexpr double kGreyRange = 127;
    calib::DepthFrame frame;
    frame.gain = kGreyRange / std::max(-display.disparityFar, display.disparityNear);
    return frame;
}

} // namespace

calib::DisplayProfile plainDisplay(const calib::DisplayProfile& display, PlainFormat format,
                                   int width, int height) {
    calib::DisplayProfile plain = display;
    plain.order = calib::ViewOrder::LeftToRight;
    plain.remap.clear();
    plain.fringe = 0;
    if (format == PlainFormat::DepthFrame) {
        plain.views = 1;
        plain.fan = calib::Fan::Centres;
        plain.law = depthFrame(display);
        plain.quilt = {1, 1, width / 2, height};
        return plain;
    }
    spanTwoEyes(plain);
    const bool halves = format == PlainFormat::SideBySide;
    plain.quilt = {2, 1, halves ? width / 2 : width, height};
    if (halves)
        plain.law = calib::TileFrame{2, 1, true, false};
    else
        plain.law = calib::ViewTable{{{0, 1, 1}}};
    return plain;
}

} // namespace autostereo::daemon
