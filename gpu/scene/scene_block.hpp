#pragma once

#include "gpu/scene/params.hpp"
#include "gpu/scene/scene_placement.hpp"

#include <glm/vec4.hpp>

#include <array>

namespace autostereo::gpu {

/// shaders/scene_block.glsl, binding 7.
struct SceneBlock {
    glm::ivec4 viewTiles{0};
    glm::vec4 form{0};
    glm::vec4 range{0};
    glm::vec4 ambient{0};
    std::array<glm::vec4, kMostSceneLights> lightPlaces{};
    std::array<glm::vec4, kMostSceneLights> lightColors{};
    std::array<glm::vec4, kMostSceneLights> lightCones{};
    std::array<glm::vec4, kMostSceneLights> lightFades{};

    /// Ambient light and the first kMostSceneLights lights.
    void set(const SceneParams& params);
};
static_assert(sizeof(SceneBlock) == 576);

/// Of a scene in its place, but for viewTiles.
[[nodiscard]] SceneBlock sceneBlock(const SceneParams& look, const ScenePlacement& placement,
                                    const calib::DisplayProfile& display, double panelAspect);

} // namespace autostereo::gpu
