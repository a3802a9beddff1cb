#include "config/read_scene.hpp"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace autostereo::config {

namespace {

using gpu::SceneLight;

constexpr Range kPlace{-1000, 1000}; // metres, directions, colours, angles: what a row may hold
constexpr double kRad = std::numbers::pi / 180;

glm::dvec3 vectorAt(const std::vector<double>& row, std::size_t first) {
    return {row[first], row[first + 1], row[first + 2]};
}

/// What cannot shine is refused: no direction, light below nothing, no reach, no cone.
void check(TomlReader& table, const char* key, const SceneLight& light) {
    if (light.kind != SceneLight::Kind::Point && glm::length(light.direction) == 0)
        table.reject(key, "has a direction of length 0");
    if (light.color.r < 0 || light.color.g < 0 || light.color.b < 0)
        table.reject(key, "has a colour below 0");
    if (!(light.reachM >= 0.001)) table.reject(key, "has a reach below 0.001");
    if (!(light.coneRad >= kRad && light.coneRad <= 179 * kRad))
        table.reject(key, "has a cone that is not 1 to 179 degrees");
}

/// Rows of one kind of light replace those of that kind that are there.
template<class MakeLight>
void readLights(TomlReader& table, const char* key, double columns, SceneLight::Kind kind,
                std::vector<SceneLight>& lights, MakeLight makeLight) {
    if (!table.has(key)) return;
    std::erase_if(lights, [&](const SceneLight& light) { return light.kind == kind; });
    for (const std::vector<double>& row :
         table.numberRows(key, {0, gpu::kMostSceneLights}, {columns, columns}, kPlace)) {
        if (row.size() != static_cast<std::size_t>(columns)) continue; // complained about
        SceneLight light = makeLight(row);
        light.kind = kind;
        check(table, key, light);
        lights.push_back(light);
    }
}

} // namespace

void readScene(TomlReader& root, gpu::SceneParams& scene) {
    auto table = root.table("scene");
    scene.up = table.choice<gpu::SceneUp>("up", {{"y", gpu::SceneUp::Y}, {"z", gpu::SceneUp::Z}},
                                          scene.up);
    scene.share = table.number("share_percent", {1, 400}, 100 * scene.share) / 100;
    scene.turnS = table.number("turn_s", {-3600, 3600}, scene.turnS);
    scene.startRad = kRad * table.number("start_deg", {-360, 360}, scene.startRad / kRad);
    scene.tiltRad = kRad * table.number("tilt_deg", {-90, 90}, scene.tiltRad / kRad);
    scene.shading = table.choice<gpu::SceneShading>("shading", gpu::kSceneShadings, scene.shading);
    const auto ambient =
        table.numbers<3>("ambient", {0, 1},
                         std::array<double, 3>{scene.ambient.r, scene.ambient.g, scene.ambient.b});
    scene.ambient = {ambient[0], ambient[1], ambient[2]};
    using Row = std::vector<double>;
    readLights(table, "directional_lights", 6, SceneLight::Kind::Directional, scene.lights,
               [](const Row& row) {
                   return SceneLight{.color = vectorAt(row, 3), .direction = vectorAt(row, 0)};
               });
    readLights(table, "point_lights", 7, SceneLight::Kind::Point, scene.lights, [](const Row& row) {
        return SceneLight{
            .color = vectorAt(row, 3), .position = vectorAt(row, 0), .reachM = row[6]};
    });
    readLights(table, "spot_lights", 11, SceneLight::Kind::Spot, scene.lights, [](const Row& row) {
        return SceneLight{.color = vectorAt(row, 6),
                          .position = vectorAt(row, 0),
                          .direction = vectorAt(row, 3),
                          .reachM = row[9],
                          .coneRad = kRad * row[10]};
    });
    if (scene.lights.size() > gpu::kMostSceneLights)
        table.reject("directional_lights", "makes more than eight lights with the other kinds");
}

} // namespace autostereo::config
