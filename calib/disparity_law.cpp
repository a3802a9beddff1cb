#include "calib/disparity_law.hpp"

#include <cmath>

namespace autostereo::calib {

DisparityLaw disparityLaw(const DisplayProfile& display, double focusM, double cameraWidthAtFocusM,
                          double depthScale) {
    DisparityLaw law;
    law.focusM = focusM;
    law.scale = depthScale * display.widthM / cameraWidthAtFocusM;
    law.viewerDistanceM = display.viewingDistanceM;
    law.fanHalfWidth = display.viewingDistanceM * std::tan(display.coneRad / 2) / display.widthM;
    law.farthest = display.disparityFar;
    law.nearest = display.disparityNear;
    return law;
}

} // namespace autostereo::calib
