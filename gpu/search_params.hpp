#pragma once

#include "calib/panel_map.hpp"
#include "gpu/params.hpp"
#include "gpu/scene/params.hpp"

#include <optional>
#include <string>
#include <vector>

namespace autostereo::gpu {

/// What a panel shows that is filled without tiles, and to which eyes
/// (shaders/searched_samples.glsl, scene_samples.glsl).
struct SearchParams {
    bool rootsOnly = false; ///< draws what was found, in stale tiles, for KeptRoots
    int views = 1;
    bool continuous = false;  ///< an eye for every phase, else one for every view
    double firstPosition = 0; ///< b at phase 0 (continuous)
    double positionPerCycle = 0;
    double channelStep = 0; ///< from red to green to blue, panel widths
    /// A scene's reference viewpoints are searched, not cameras' layers; and how they are lit.
    std::optional<SceneShading> scene{};
    bool tilesOnly = false; ///< draws the tiles that SceneTiles lists; filled by phase only
};

/// The display's views one by one, or an eye for every phase where `positions` wants that and the
/// map allows it.
[[nodiscard]] SearchParams searchParams(const calib::DisplayProfile& display,
                                        const calib::PanelMap& map, ViewPositions positions);

/// Of the interleavers' shaders.
[[nodiscard]] std::vector<std::string> definesOf(const std::optional<SearchParams>& search);

} // namespace autostereo::gpu
