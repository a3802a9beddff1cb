#include "calib/disparity_law.hpp"

#include <cmath>

namespace autostereo::calib {

double fanHalfWidth(const DisplayProfile& display) {
    return display.viewingDistanceM * std::tan(display.coneRad / 2) / display.widthM;
}

DisparityLaw disparityLaw(const DisplayProfile& display, double focusM, double cameraWidthAtFocusM,
                          double depthScale) {
    DisparityLaw law;
    law.focusM = focusM;
    law.scale = depthScale * display.widthM / cameraWidthAtFocusM;
    law.viewerDistanceM = display.viewingDistanceM;
    law.fanHalfWidth = fanHalfWidth(display);
    law.farthest = display.disparityFar;
    law.nearest = display.disparityNear;
    return law;
}

DepthInterval unclampedDepths(const DisparityLaw& law) {
    if (!(law.scale > 0)) return {0, std::numeric_limits<double>::infinity()};
    return {law.focusM - law.heightAt(law.nearest) / law.scale,
            law.focusM - law.heightAt(law.farthest) / law.scale};
}

} // namespace autostereo::calib
