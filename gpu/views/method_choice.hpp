#pragma once

#include "gpu/views/view_synthesis.hpp"

#include <vector>

namespace autostereo::gpu {

/// What one method took and how far it was from the exact panel.
struct MethodTrial {
    Method method = Method::Direct;
    double milliseconds = 0;
    double psnrDb = 0;
};

/// Method::Auto's decision and what it stands on.
struct MethodChoice {
    Method method = Method::Direct;
    std::vector<MethodTrial> trials;
};

/// Draws the scene by every method, a second at most beyond what the fastest takes, and takes the
/// fastest whose panel is no farther than `params.synthesis.leastDb` from the direct method's,
/// which is exact. Waits for the GPU. Needs MeshBlock at binding 0. Throws GlError.
[[nodiscard]] MethodChoice chooseMethod(const PipelineParams& params,
                                        const calib::DisplayProfile& display, int panelWidth,
                                        int panelHeight, const CyclopeanScene& scene);

} // namespace autostereo::gpu
