#pragma once

#include "calib/depth_budget.hpp"
#include "devices/clock.hpp"
#include "gpu/depth_statistics.hpp"
#include "gpu/params.hpp"
#include "gpu/scene_geometry.hpp"

namespace autostereo::gpu {

/// Keeps the scene inside the display's depth budget: from the depths that the panel showed two
/// frames ago, what lies in its plane and how deep the scene is drawn. Thread-bound.
class DepthBudget {
  public:
    /// Throws GlError.
    DepthBudget(const DepthBudgetParams& params, const calib::DisplayProfile& display);

    /// Before the frame's mesh is built: moves `geometry`'s law on.
    void follow(devices::TimePoint capturedAt, SceneGeometry& geometry);
    /// After it was built. True where this was the first frame that measures anything: it is waited
    /// for, `geometry` changes at once, and the mesh has to be built again.
    [[nodiscard]] bool measure(const gl::Texture& points, SceneGeometry& geometry);

    /// Whether a frame like the last one would be drawn otherwise than that. Waits for the GPU: to
    /// be asked where nothing else is to do.
    [[nodiscard]] bool moves(const SceneGeometry& geometry);

    /// Share of what the panel showed two frames ago that lay outside the budget and was clamped.
    [[nodiscard]] double clampedShare() const { return clampedShare_; }

  private:
    [[nodiscard]] bool aim(const DepthStatistics::Depths& depths, const SceneGeometry& geometry);
    void place(double elapsedS, SceneGeometry& geometry);

    DepthBudgetParams params_;
    calib::DisplayProfile display_;
    DepthStatistics statistics_;
    calib::PlacementFollower follower_;
    std::optional<calib::DepthPlacement> goal_;
    std::optional<devices::TimePoint> before_;
    double clampedShare_ = 0;
};

} // namespace autostereo::gpu
