#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace autostereo::gpu {

/// What a window system offers.
struct MonitorInfo {
    std::string name;
    int width = 0; ///< current mode, pixels
    int height = 0;
    int refreshHz = 0;
};

/// Which monitor a full-screen window wants.
struct MonitorRequest {
    int width = 0; ///< the display's native mode, pixels; 0 x 0: any
    int height = 0;
    std::string connector; ///< the kernel's name, "HDMI-A-1"; empty: any
    bool force = false;    ///< take it even if its mode differs
};

struct MonitorChoice {
    std::size_t index = 0;
    std::string warning; ///< one sentence, or empty
};

/// The monitor on the connector, else the first in the right mode, else (any size, or force) the
/// first, which is the primary one. A connector that no name fits is searched by size and taken
/// with a warning if there is one such monitor only. Throws DisplayNotFound. Pure.
[[nodiscard]] MonitorChoice chooseMonitor(std::span<const MonitorInfo> monitors,
                                          const MonitorRequest& request);

/// What became of the monitor that a full-screen window was opened on (nothing: it is gone), where
/// sub-pixels would no longer be the panel's own. Pure.
[[nodiscard]] std::optional<std::string> monitorChange(const MonitorInfo& was,
                                                       const std::optional<MonitorInfo>& is);

/// Which of the window system's names is the kernel's connector. They differ by driver: HDMI-A-1
/// is HDMI-A-1 (Wayland), HDMI-1 or HDMI-1-1 on a second card (X, modesetting), HDMI1 (intel),
/// HDMI-A-0 (amdgpu, radeon), HDMI-0 (nvidia); DP-1 is DisplayPort-0 for amdgpu. A name with a 0
/// shows that all of them count from 0. Nothing: none fits, or more than one.
[[nodiscard]] std::optional<std::size_t>
monitorOfConnector(std::string_view connector, std::span<const std::string> monitorNames);

} // namespace autostereo::gpu
