#pragma once

#include "devices/mesh/mesh_scene.hpp"
#include "gpu/scene/params.hpp"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

/// What an eye sees of a scene of triangles, in double precision: a ray through the panel against
/// every triangle, then Blinn-Phong at the point that is hit.
namespace autostereo::oracle {

struct SceneCorner {
    glm::dvec3 place;  ///< display space, metres
    glm::dvec3 normal; ///< length one
    glm::dvec2 uv;
};
struct SceneTriangle {
    std::array<SceneCorner, 3> corners;
    int material;
};

/// Every triangle where it stands at a time.
inline std::vector<SceneTriangle> trianglesOf(const devices::mesh::MeshScene& scene, double seconds,
                                              const glm::dmat4& toDisplay) {
    std::vector<SceneTriangle> triangles;
    const std::vector<glm::dmat4> nodes = scene.transforms(seconds);
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        const glm::dmat4 way = toDisplay * nodes[n];
        const glm::dmat3 turn = glm::transpose(glm::inverse(glm::dmat3(way)));
        for (const devices::mesh::MeshPart& part : scene.nodes[n].parts)
            for (std::uint32_t i = 0; i < part.indexCount; i += 3) {
                SceneTriangle triangle{{}, part.material};
                for (std::uint32_t c = 0; c < 3; ++c) {
                    const auto& vertex = scene.vertices[scene.indices[part.firstIndex + i + c]];
                    triangle.corners[c] = {way * glm::dvec4(vertex.position, 1),
                                           glm::normalize(turn * glm::dvec3(vertex.normal)),
                                           vertex.uv};
                }
                triangles.push_back(triangle);
            }
    }
    return triangles;
}

struct SceneHit {
    const SceneTriangle* triangle;
    SceneCorner at; ///< normal not yet of length one
};

/// The first triangle from `eye` through the panel's point (x, y), heights shown at `flattening`.
inline std::optional<SceneHit> firstHit(const std::vector<SceneTriangle>& triangles,
                                        const glm::dvec3& eye, double x, double y,
                                        double flattening) {
    const glm::dvec3 ray = glm::dvec3(x, y, 0) - eye;
    double nearest = std::numeric_limits<double>::infinity();
    std::optional<SceneHit> found;
    for (const SceneTriangle& triangle : triangles) {
        std::array<glm::dvec3, 3> p;
        for (std::size_t c = 0; c < 3; ++c)
            p[c] = triangle.corners[c].place * glm::dvec3(1, 1, flattening);
        // eye + t ray = p0 + s (p1 - p0) + r (p2 - p0)
        const glm::dmat3 system(-ray, p[1] - p[0], p[2] - p[0]);
        if (glm::determinant(system) == 0) continue;
        const glm::dvec3 tsr = glm::inverse(system) * (eye - p[0]);
        const double s = tsr.y, r = tsr.z;
        if (tsr.x <= 0 || tsr.x >= nearest || s < 0 || r < 0 || s + r > 1) continue;
        nearest = tsr.x;
        const auto& [a, b, c] = triangle.corners;
        const double q = 1 - s - r;
        found =
            SceneHit{&triangle,
                     {q * a.place + s * b.place + r * c.place,
                      q * a.normal + s * b.normal + r * c.normal, q * a.uv + s * b.uv + r * c.uv}};
    }
    return found;
}

inline double lightOf(double screen) {
    return screen <= 0.04045 ? screen / 12.92 : std::pow((screen + 0.055) / 1.055, 2.4);
}
inline double levelOf(double light) {
    const double c = std::clamp(light, 0.0, 1.0);
    return 255 * (c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055);
}

/// Between the four texels around, in light; repeated beyond the edges.
inline glm::dvec3 textureAt(const devices::mesh::MeshTexture& texture, const glm::dvec2& uv) {
    const double x = uv.x * texture.width - 0.5, y = uv.y * texture.height - 0.5;
    const int left = static_cast<int>(std::floor(x)), top = static_cast<int>(std::floor(y));
    const auto texel = [&](int column, int row) {
        const auto wrapped = [](int value, int size) { return (value % size + size) % size; };
        const auto first =
            4 * static_cast<std::size_t>(wrapped(row, texture.height) * texture.width +
                                         wrapped(column, texture.width));
        glm::dvec3 color;
        for (int channel = 0; channel < 3; ++channel)
            color[channel] = lightOf(
                std::to_integer<int>(texture.rgba[first + static_cast<std::size_t>(channel)]) /
                255.0);
        return color;
    };
    const double right = x - left, down = y - top;
    return (1 - down) * ((1 - right) * texel(left, top) + right * texel(left + 1, top)) +
           down * ((1 - right) * texel(left, top + 1) + right * texel(left + 1, top + 1));
}

struct SceneLightSum {
    glm::dvec3 diffuse, specular;
};
inline SceneLightSum lightAt(const gpu::SceneParams& look, const glm::dvec3& place,
                             const glm::dvec3& normal, const glm::dvec3& eye, double shininess) {
    using Kind = gpu::SceneLight::Kind;
    SceneLightSum sum{look.ambient, glm::dvec3(0)};
    for (const gpu::SceneLight& light : look.lights) {
        const bool placed = light.kind != Kind::Directional;
        const glm::dvec3 way = placed ? light.position - place : -light.direction;
        const glm::dvec3 l = glm::normalize(way);
        double strength = 1;
        if (placed) strength /= 1 + std::pow(glm::length(way) / light.reachM, 2);
        if (light.kind == Kind::Spot) {
            const double outer = std::cos(light.coneRad / 2);
            const double inner = std::cos(0.9 * light.coneRad / 2);
            const double t = std::clamp((glm::dot(-l, glm::normalize(light.direction)) - outer) /
                                            (inner - outer),
                                        0.0, 1.0);
            strength *= t * t * (3 - 2 * t);
        }
        const double facing = glm::dot(normal, l);
        if (facing <= 0) continue;
        const glm::dvec3 h = glm::normalize(l + glm::normalize(eye - place));
        sum.diffuse += strength * facing * light.color;
        sum.specular +=
            strength * std::pow(std::max(0.0, glm::dot(normal, h)), shininess) * light.color;
    }
    return sum;
}

/// 0 to 255 on the screen, not rounded. Shading None, Textured or PerPixel.
inline glm::dvec3 colorOf(const SceneHit& hit, const devices::mesh::MeshScene& scene,
                          const gpu::SceneParams& look, const glm::dvec3& eye) {
    const devices::mesh::MeshMaterial& material =
        scene.materials[static_cast<std::size_t>(hit.triangle->material)];
    glm::dvec3 light = material.diffuse;
    if (material.texture >= 0 && look.shading != gpu::SceneShading::None)
        light *= textureAt(scene.textures[static_cast<std::size_t>(material.texture)], hit.at.uv);
    if (look.shading == gpu::SceneShading::PerPixel) {
        const SceneLightSum sum =
            lightAt(look, hit.at.place, glm::normalize(hit.at.normal), eye, material.shininess);
        light = light * sum.diffuse + glm::dvec3(material.specular) * sum.specular;
    }
    light += glm::dvec3(material.emissive);
    return {levelOf(light.r), levelOf(light.g), levelOf(light.b)};
}

} // namespace autostereo::oracle
