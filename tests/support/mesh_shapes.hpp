#pragma once

#include "devices/mesh/mesh_scene.hpp"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace autostereo::test {

/// An empty scene with one material and a node that nothing moves.
inline devices::mesh::MeshScene emptyScene() {
    devices::mesh::MeshScene scene;
    scene.materials.push_back({.name = "default"});
    return scene;
}

/// The triangles added since `first` become a node's part.
inline void addNode(devices::mesh::MeshScene& scene, std::size_t first, int material,
                    const glm::dvec3& at) {
    devices::mesh::MeshNode node;
    node.pose.translation = at;
    node.parts.push_back({static_cast<std::uint32_t>(first),
                          static_cast<std::uint32_t>(scene.indices.size() - first), material});
    scene.nodes.push_back(node);
}

/// A ball of 2 `rows` x `rows` quads with smooth normals, as a node of its own.
inline void addBall(devices::mesh::MeshScene& scene, const glm::dvec3& middle, double radius,
                    int rows, int material) {
    const std::size_t first = scene.indices.size();
    const auto base = static_cast<std::uint32_t>(scene.vertices.size());
    const int columns = 2 * rows;
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column) {
            const double up = std::numbers::pi * row / rows;
            const double around = 2 * std::numbers::pi * column / columns;
            const glm::dvec3 normal{std::sin(up) * std::cos(around), std::cos(up),
                                    -std::sin(up) * std::sin(around)};
            scene.vertices.push_back(
                {radius * normal, normal, glm::dvec2(2.0 * column / columns, 1.0 * row / rows)});
        }
    const auto across = static_cast<std::uint32_t>(columns) + 1;
    for (std::uint32_t row = 0; row < static_cast<std::uint32_t>(rows); ++row)
        for (std::uint32_t column = 0; column + 1 < across; ++column) {
            const std::uint32_t a = base + row * across + column, b = a + across;
            scene.indices.insert(scene.indices.end(), {a, b, a + 1, a + 1, b, b + 1});
        }
    addNode(scene, first, material, middle);
}

/// A texture of 2 x 2 strong colours.
inline int addTexture(devices::mesh::MeshScene& scene) {
    devices::mesh::MeshTexture texture{2, 2, {}};
    for (const int level :
         {255, 40, 30, 255, 20, 200, 60, 255, 30, 60, 220, 255, 240, 240, 90, 255})
        texture.rgba.push_back(static_cast<std::byte>(level));
    scene.textures.push_back(texture);
    return static_cast<int>(scene.textures.size()) - 1;
}

/// Two balls, one behind the other, of unlike materials, one of them textured.
inline devices::mesh::MeshScene twoBalls() {
    devices::mesh::MeshScene scene = emptyScene();
    scene.materials[0] = {.name = "painted",
                          .diffuse = {0.7F, 0.6F, 0.8F},
                          .specular = glm::vec3(0.4F),
                          .shininess = 20,
                          .emissive = {0.02F, 0, 0},
                          .texture = addTexture(scene)};
    scene.materials.push_back({.name = "polished",
                               .diffuse = {0.1F, 0.4F, 0.2F},
                               .specular = {0.8F, 0.7F, 0.3F},
                               .shininess = 90});
    addBall(scene, {-0.6, 0.1, 0.5}, 1, 10, 0);
    addBall(scene, {0.7, -0.2, -0.4}, 0.8, 10, 1);
    return scene;
}

} // namespace autostereo::test
