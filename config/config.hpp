#pragma once

#include "calib/display_profile.hpp"
#include "calib/sensor_rig.hpp"
#include "devices/params.hpp"
#include "gpu/params.hpp"

#include <optional>
#include <string>

namespace autostereo::config {

enum class Output { Window, Offscreen };
enum class Speed { Realtime, Max };

/// When what the depth budget leaves open follows the scene.
enum class Following { Live, Always, Never };

struct LogParams {
    std::string level = "info"; ///< error, warn, info, debug, trace
};

/// Everything a configuration file can say: all rooms' params together.
struct Config {
    std::string input = "sim:person";
    std::string display;            ///< profile name or file; empty: preview
    std::optional<std::string> rig; ///< rig file; none: the input's own calibration
    std::optional<Output> output;   ///< none: window if there is a display, else off-screen
    devices::SyncParams sync;
    devices::ReconnectParams reconnect;
    gpu::PipelineParams pipeline;
    Following depthFollows = Following::Live; ///< decides pipeline.budget.follow, by command
    LogParams log;
};

} // namespace autostereo::config
