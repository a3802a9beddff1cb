#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

namespace autostereo::gpu {

/// What de Sorbier 2008 compares: only the material's colour, times its texture, lit at the
/// vertices, lit at every pixel.
enum class SceneShading { None, Textured, PerVertex, PerPixel };
inline constexpr std::array<std::pair<std::string_view, SceneShading>, 4> kSceneShadings{
    {{"none", SceneShading::None},
     {"textured", SceneShading::Textured},
     {"per-vertex", SceneShading::PerVertex},
     {"per-pixel", SceneShading::PerPixel}}};

/// Which of a scene's own axes points up: y in glTF, z in many scans.
enum class SceneUp { Y, Z };

/// In display space (metres, origin in the panel's centre, x right, y up, z toward the viewer), so
/// that lights stand still while the scene turns. Colours are linear light.
struct SceneLight {
    enum class Kind { Directional, Point, Spot };
    Kind kind = Kind::Directional;
    glm::dvec3 color{1};
    glm::dvec3 position{0};         ///< of point and spot lights
    glm::dvec3 direction{0, 0, -1}; ///< in which light goes; of directional and spot lights
    /// Light falls off as 1 / (1 + (distance / reach)^2); of point and spot lights, metres.
    double reachM = 1;
    double coneRad = 0.5; ///< of spot lights, whole angle; light fades over its outer tenth
};
constexpr std::size_t kMostSceneLights = 8;

/// How mesh content is put in front of the viewer, lit and turned.
struct SceneParams {
    SceneUp up = SceneUp::Y;
    double share = 0.8;    ///< of the panel's width or height, whichever it fills first
    double depthScale = 1; ///< multiplies heights as they are shown, 0: all in the panel's plane
    double turnS = 12;     ///< of one turn about the vertical, negative: the other way, 0: none
    double startRad = 0;   ///< the turn at time 0
    double tiltRad =
        12 * std::numbers::pi / 180; ///< of the whole scene toward the viewer, about the horizontal
    SceneShading shading = SceneShading::PerPixel;
    glm::dvec3 ambient{0.05};
    std::vector<SceneLight> lights{
        {.color = glm::dvec3(0.8), .direction = {0.5, -0.7, -0.8}},
        {.color = glm::dvec3(0.12, 0.15, 0.2), .direction = {-0.8, 0.1, -0.4}}};
};

} // namespace autostereo::gpu
