#pragma once

#include "calib/display_profile.hpp"
#include "devices/mesh/mesh_scene.hpp"
#include "gpu/scene/params.hpp"

#include <glm/mat4x4.hpp>

namespace autostereo::gpu {

/// A scene's place in display space: its middle in the panel's centre, scaled so that, however it
/// is turned, it spans `SceneParams::share` of the panel and stays within it.
struct ScenePlacement {
    glm::dvec3 middle{0}; ///< of the upright scene's box, its own units
    double scale = 1;     ///< display metres per unit
    double radiusM = 0;   ///< horizontal reach from the vertical axis when turned
    double heightM = 0;   ///< half the height, likewise
    /// Heights above the panel are shown at this share of themselves: params.depthScale where the
    /// display's budget has room for that. Light is reckoned in the undistorted scene.
    double flattening = 1;
    double nearM = 0, farM = 0; ///< of what is drawn, heights above the panel after flattening

    /// The scene's frame -> display space, undistorted, at a time.
    [[nodiscard]] glm::dmat4 transform(const SceneParams& params, double seconds) const;
};

/// The turn that makes a scene's own upward axis y.
[[nodiscard]] glm::dmat3 uprightTurn(SceneUp up);

/// `extent`: of the scene after its uprightTurn. `panelAspect` = width / height.
[[nodiscard]] ScenePlacement scenePlacement(const devices::mesh::MeshExtent& extent,
                                            const SceneParams& params,
                                            const calib::DisplayProfile& display,
                                            double panelAspect);

} // namespace autostereo::gpu
