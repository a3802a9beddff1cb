#include "gpu/scene/scene_block.hpp"

#include "calib/disparity_law.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace autostereo::gpu {

void SceneBlock::set(const SceneParams& params) {
    constexpr double kFade = 0.9; // of a cone: there its light begins to fade
    const std::size_t count = std::min(params.lights.size(), kMostSceneLights);
    form.w = static_cast<float>(count);
    ambient = glm::dvec4(params.ambient, 0);
    for (std::size_t i = 0; i < count; ++i) {
        const SceneLight& light = params.lights[i];
        const bool isPlaced = light.kind != SceneLight::Kind::Directional;
        const glm::dvec3 along = glm::normalize(light.direction);
        lightPlaces[i] = isPlaced ? glm::dvec4(light.position, 1) : glm::dvec4(-along, 0);
        lightColors[i] = glm::dvec4(light.color, 1 / (light.reachM * light.reachM));
        lightCones[i] = glm::dvec4(along, 0);
        const double half = light.coneRad / 2;
        lightFades[i] = light.kind == SceneLight::Kind::Spot
                            ? glm::dvec4(std::cos(half), std::cos(kFade * half), 0, 0)
                            : glm::dvec4(-3, -2, 0, 0); // shines all around
    }
}

SceneBlock sceneBlock(const SceneParams& look, const ScenePlacement& placement,
                      const calib::DisplayProfile& display, double panelAspect) {
    constexpr double kSlack = 1.01; // rounding keeps inside of the depth range
    SceneBlock block;
    block.set(look);
    block.form.x = static_cast<float>(display.widthM / 2);
    block.form.y = static_cast<float>(display.widthM / panelAspect / 2);
    block.form.z = static_cast<float>(placement.flattening);
    block.range = glm::dvec4(kSlack * placement.nearM, kSlack * placement.farM,
                             calib::fanHalfWidth(display), display.viewingDistanceM);
    return block;
}

} // namespace autostereo::gpu
