#pragma once

#include "devices/display/calibration_cache.hpp"
#include "gpu/pipeline.hpp"

#include <optional>
#include <string>

namespace autostereo::daemon {

/// What Method::Auto chose earlier, for this renderer, display, panel, depth camera and bound of
/// error: trying all methods takes seconds. A file that cannot be read or kept costs that again.
class MethodMemory {
  public:
    /// `folder` as DisplayPlaces::state.
    MethodMemory(const std::filesystem::path& folder, const gpu::PipelineParams& params,
                 const calib::DisplayProfile& display, int panelWidth, int panelHeight,
                 const calib::SensorRig& rig);

    /// `params` with what was chosen earlier in place of Auto.
    [[nodiscard]] gpu::PipelineParams apply(gpu::PipelineParams params) const;
    /// Nothing, or why it could not be kept.
    [[nodiscard]] std::optional<std::string> keep(const gpu::MethodChoice& choice) const;

  private:
    devices::CalibrationCache files_;
    std::string key_;
};

} // namespace autostereo::daemon
