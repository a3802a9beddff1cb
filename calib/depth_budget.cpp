#include "calib/depth_budget.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace autostereo::calib {

namespace {

double between(double from, double to, double share) {
    if (from == to || !(from > 0 && to > 0)) return to; // a flat scale has no ratio to go by
    return from * std::pow(to / from, share);
}

double ratio(double a, double b) {
    if (a == b) return 0;
    return a > 0 && b > 0 ? std::abs(std::log(a / b)) : std::numeric_limits<double>::infinity();
}

} // namespace

DepthPlacement placementFor(const SceneDepths& scene, const DisplayProfile& display,
                            double framingWidth, const PlacementLimits& limits) {
    const double focus = std::clamp(scene.subjectM, limits.nearestFocusM, limits.farthestFocusM);
    const DisparityLaw natural = disparityLaw(display, focus, framingWidth * focus, 1);
    double scale = limits.mostScale;
    const auto fit = [&](double z, double disparity) {
        const double height = natural.scale * (focus - z);
        const double most = natural.heightAt(disparity);
        if (height / most > 0) scale = std::min(scale, most / height); // on this side of the panel
    };
    fit(scene.nearM, display.disparityNear);
    fit(scene.farM, display.disparityFar);
    return {focus, std::max(scale, limits.leastScale)};
}

const DepthPlacement& PlacementFollower::follow(const DepthPlacement& goal, double elapsedS) {
    constexpr double kLongestStepS = 0.5;
    if (!now_) return now_.emplace(goal);
    moving_ = moves(goal);
    if (!moving_) return *now_;
    const double step = elapsedS > 0 ? std::min(elapsedS, kLongestStepS) : 0;
    const double share = -std::expm1(-step / motion_.timeConstantS);
    now_->focusM = between(now_->focusM, goal.focusM, share);
    now_->scale = between(now_->scale, goal.scale, share);
    return *now_;
}

bool PlacementFollower::moves(const DepthPlacement& goal) const {
    constexpr double kCloseEnough = 0.1; // of the dead band: nobody sees the rest
    if (!now_) return true;
    const double off = std::max(ratio(goal.focusM, now_->focusM), ratio(goal.scale, now_->scale));
    const double band = std::log1p(motion_.deadBand);
    return off > (moving_ ? kCloseEnough * band : band);
}

} // namespace autostereo::calib
