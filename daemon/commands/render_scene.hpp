#pragma once

#include "config/config.hpp"
#include "daemon/command_line.hpp"

namespace autostereo::daemon {

/// `render` of a scene of triangles, as it is at frame number options.frame of 30 a second. The
/// exit code. Throws UsageError where cameras are asked for, DeviceError, GlError.
[[nodiscard]] int renderScene(const RenderOptions& options, Picture as,
                              const config::Config& config, const calib::DisplayProfile& display);

} // namespace autostereo::daemon
