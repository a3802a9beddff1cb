#include "gpu/depth_budget.hpp"

#include <chrono>
#include <limits>

namespace autostereo::gpu {

namespace {

/// A number that is given leaves nothing to choose.
DepthBudgetParams narrowed(DepthBudgetParams params) {
    auto& limits = params.limits;
    if (params.focusM) limits.nearestFocusM = limits.farthestFocusM = *params.focusM;
    if (params.depthScale) limits.leastScale = limits.mostScale = *params.depthScale;
    return params;
}

} // namespace

DepthBudget::DepthBudget(const DepthBudgetParams& params, const calib::DisplayProfile& display)
    : params_(narrowed(params)), display_(display), follower_(params.motion) {}

void DepthBudget::follow(devices::TimePoint capturedAt, SceneGeometry& geometry) {
    if (const auto depths = statistics_.take()) static_cast<void>(aim(*depths, geometry));
    const std::chrono::duration<double> elapsed = capturedAt - before_.value_or(capturedAt);
    before_ = capturedAt;
    if (goal_) place(elapsed.count(), geometry);
}

bool DepthBudget::measure(const gl::Texture& points, SceneGeometry& geometry) {
    statistics_.measure(points);
    if (goal_) return false;
    const auto depths = statistics_.takeNewest();
    if (!depths || !aim(*depths, geometry)) return false;
    place(0, geometry);
    return true;
}

bool DepthBudget::moves(const SceneGeometry& geometry) {
    if (const auto depths = statistics_.takeNewest()) static_cast<void>(aim(*depths, geometry));
    return goal_ && follower_.moves(*goal_);
}

bool DepthBudget::aim(const DepthStatistics::Depths& depths, const SceneGeometry& geometry) {
    const double framingWidth = geometry.framing.width;
    const double cutM = geometry.cutM > 0 ? geometry.cutM : std::numeric_limits<double>::infinity();
    const calib::DepthHistogram panel = depths.panel.upTo(cutM), centre = depths.centre.upTo(cutM);
    const auto subject = (centre.total() > 0 ? centre : panel).quantile(params_.subjectShare);
    if (!subject) return false; // nothing measured: things stay where they are
    const auto [nearest, farthest] = unclampedDepths(geometry.law);
    clampedShare_ = 1 - panel.shareBetween(nearest, farthest);
    goal_ = calib::placementFor({panel.quantile(params_.nearShare).value_or(*subject), *subject,
                                 panel.quantile(params_.farShare).value_or(*subject)},
                                display_, framingWidth, params_.limits);
    return true;
}

void DepthBudget::place(double elapsedS, SceneGeometry& geometry) {
    const auto& [focus, scale] = follower_.follow(*goal_, elapsedS);
    geometry.law = calib::disparityLaw(display_, focus, geometry.framing.width * focus, scale);
}

} // namespace autostereo::gpu
