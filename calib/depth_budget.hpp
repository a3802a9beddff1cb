#pragma once

#include "calib/disparity_law.hpp"
#include "calib/display_profile.hpp"

#include <optional>

namespace autostereo::calib {

/// What matters of a scene's depths, metres at the colour camera: what stands in the panel's plane,
/// and between which two the display's budget should reach without clamping.
struct SceneDepths {
    double nearM = 1;
    double subjectM = 1;
    double farM = 1;
};

/// Where a scene is put: `focusM` in the panel's plane, depth relative to the natural one, in which
/// the cameras' width at the focus fills the panel's.
struct DepthPlacement {
    double focusM = 1;
    double scale = 1;
    [[nodiscard]] bool operator==(const DepthPlacement&) const = default;
};

/// What holds whatever the scene is; least = most is a fixed number.
struct PlacementLimits {
    double nearestFocusM = 0.1;
    double farthestFocusM = 20;
    double leastScale = 0.5;
    double mostScale = 1;
};

/// The subject in the panel's plane, and the largest scale at which near and far keep inside the
/// display's budget, both within the limits. `framingWidth`: of the panel on the cameras' z = 1
/// plane (calib::Framing).
[[nodiscard]] DepthPlacement placementFor(const SceneDepths& scene, const DisplayProfile& display,
                                          double framingWidth, const PlacementLimits& limits);

/// A placement that follows its goal slowly: it rests exactly, until the goal leaves a dead band
/// around it; then it approaches with a time constant, and rests again close to it. Depends on
/// nothing but what it is told, so that replays repeat. Thread-bound.
class PlacementFollower {
  public:
    struct Motion {
        double timeConstantS = 1.5; ///< after which 63 % of the way are done
        double deadBand = 0.1;      ///< relative, of focus and scale
    };
    explicit PlacementFollower(const Motion& motion) : motion_(motion) {}

    /// The first goal is reached at once, later ones within `elapsedS` of travel; negative and
    /// endless times count as none and half a second.
    const DepthPlacement& follow(const DepthPlacement& goal, double elapsedS);
    /// Whether it would leave its place for that goal.
    [[nodiscard]] bool moves(const DepthPlacement& goal) const;
    [[nodiscard]] const std::optional<DepthPlacement>& placement() const { return now_; }

  private:
    Motion motion_;
    bool moving_ = false;
    std::optional<DepthPlacement> now_;
};

} // namespace autostereo::calib
