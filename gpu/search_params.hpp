#pragma once

namespace autostereo::gpu {

/// Which eyes a panel shows that is filled without tiles (shaders/searched_samples.glsl).
struct SearchParams {
    bool rootsOnly = false; ///< draws what was found, in stale squares, for KeptRoots
    int views = 1;
    bool continuous = false;  ///< an eye for every phase, else one for every view
    double firstPosition = 0; ///< b at phase 0 (continuous)
    double positionPerCycle = 0;
    double channelStep = 0; ///< from red to green to blue, panel widths
};

} // namespace autostereo::gpu
