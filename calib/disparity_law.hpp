#pragma once

#include "calib/display_profile.hpp"

#include <algorithm>
#include <limits>

namespace autostereo::calib {

/// Camera depth -> disparity at the edge of the fan (|b| = 1), in panel widths, near > 0:
/// Z = scale (focus - z), d = Bx Z / (D - Z), clamped to the display's budget. In a view at
/// position b a point of the cyclopean picture at u is seen at x = u - b d.
struct DisparityLaw {
    double focusM = 1;          ///< camera depth in the panel's plane
    double scale = 1;           ///< display metres per camera metre
    double viewerDistanceM = 1; ///< D
    double fanHalfWidth = 0;    ///< Bx = D tan(cone / 2) / W, panel widths
    double farthest = 0;        ///< budget, panel widths: farthest <= 0 <= nearest
    double nearest = 0;
    [[nodiscard]] bool operator==(const DisparityLaw&) const = default;

    /// Height above the panel, display metres, at which disparity is `d`; minus infinity where none
    /// reaches it, because behind the panel disparity stays above -Bx.
    [[nodiscard]] double heightAt(double d) const {
        constexpr double kNone = -std::numeric_limits<double>::infinity();
        return fanHalfWidth + d > 0 ? d * viewerDistanceM / (fanHalfWidth + d) : kNone;
    }
    [[nodiscard]] double disparity(double z) const {
        const double height = scale * (focusM - z);
        const double gap = viewerDistanceM - height;
        if (!(gap > 0)) return nearest; // at or behind the viewer's eye
        return std::clamp(fanHalfWidth * height / gap, farthest, nearest);
    }
};

/// Camera depths whose disparity the budget does not clamp: the nearest and the farthest, infinite
/// where no depth is too far.
struct DepthInterval {
    double nearestM;
    double farthestM;
};
[[nodiscard]] DepthInterval unclampedDepths(const DisparityLaw& law);

/// Bx = D tan(cone / 2) / W: from the middle of the fan to its edge, panel widths.
[[nodiscard]] double fanHalfWidth(const DisplayProfile& display);

/// `cameraWidthAtFocusM`: what of the scene fills the panel's width in the focus plane, metres.
[[nodiscard]] DisparityLaw disparityLaw(const DisplayProfile& display, double focusM,
                                        double cameraWidthAtFocusM, double depthScale);

} // namespace autostereo::calib
