#pragma once

#include "devices/clock.hpp"
#include "devices/v4l2/video_node.hpp"

#include <optional>
#include <string>
#include <vector>

namespace autostereo::devices::v4l2 {

enum class PowerLine : std::uint8_t { Off, Hz50, Hz60, Auto };

/// What is set on a camera; unset: as the camera has it.
struct ControlParams {
    std::optional<Duration> exposure; ///< none: automatic
    std::optional<PowerLine> powerLine;
    std::optional<int> whiteBalanceK; ///< none: automatic
};

/// Sets a running camera's controls (some cameras forget them when a stream starts); the frame rate
/// has priority over the exposure, so that it holds in the dark. What the camera refuses comes back
/// as sentences; what it doesn't have and nobody asked for is left alone.
[[nodiscard]] std::vector<std::string> setControls(const VideoNode& node,
                                                   const ControlParams& params);

/// How long a frame is exposed; 0: the camera doesn't say.
[[nodiscard]] Duration exposureOf(const VideoNode& node);

} // namespace autostereo::devices::v4l2
