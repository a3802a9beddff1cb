#pragma once

#include "calib/cyclopean_grid.hpp"
#include "calib/disparity_law.hpp"
#include "calib/display_profile.hpp"
#include "calib/framing.hpp"
#include "calib/sensor_rig.hpp"
#include "devices/frame.hpp"
#include "gpu/params.hpp"

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>

namespace autostereo::gpu {

/// How the scene is put behind the glass: what the panel frames, and how depth becomes disparity.
struct SceneGeometry {
    calib::Framing framing;
    calib::DisparityLaw law;
    calib::CyclopeanGrid grid;
    double cutM = 0; ///< BackdropParams
    [[nodiscard]] bool operator==(const SceneGeometry&) const = default;
};

/// Depth counts that are measurements, inclusive, for a frame's unit.
struct CountRange {
    std::uint32_t nearest = 1;
    std::uint32_t farthest = 65534;
};
[[nodiscard]] CountRange countRange(const DepthMeshParams& mesh, double depthUnitM);

/// Median depth, at the colour camera, of the picture's central third (of the whole picture where
/// that has no measurement); none where nothing is measured.
[[nodiscard]] std::optional<double>
medianDepth(const devices::Frame& depth, const calib::SensorRig& rig, const DepthMeshParams& mesh);

/// `panelAspect` = width / height in pixels (square pixels).
[[nodiscard]] SceneGeometry sceneGeometry(const calib::SensorRig& rig,
                                          const calib::DisplayProfile& display,
                                          const PipelineParams& params, double panelAspect,
                                          double focusM);

/// Depth relative to the natural one, in which what the panel frames at the focus fills it.
[[nodiscard]] double relativeScale(const SceneGeometry& geometry,
                                   const calib::DisplayProfile& display);

/// The colour camera's own frame, texel for pixel where its lens is straight, for a camera moved by
/// `offset` (metres along its axes): no budget, margins for what comes into view.
[[nodiscard]] SceneGeometry movedCameraGeometry(const calib::SensorRig& rig, glm::dvec3 offset);

} // namespace autostereo::gpu
