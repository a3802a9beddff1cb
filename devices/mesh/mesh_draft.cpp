#include "devices/mesh/mesh_draft.hpp"

#include "devices/input.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace autostereo::devices::mesh {

namespace {

bool isFinite(const glm::vec3& value) {
    return std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z);
}

/// Triangles with a corner that is nowhere go, and parts follow.
void dropBadTriangles(MeshScene& scene) {
    const std::size_t triangles = scene.indices.size() / 3;
    std::vector<std::uint32_t> kept(triangles + 1, 0); // before triangle i, triangles
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < triangles; ++i) {
        kept[i] = next;
        const std::array<std::uint32_t, 3> corners{scene.indices[3 * i], scene.indices[3 * i + 1],
                                                   scene.indices[3 * i + 2]};
        if (!std::ranges::all_of(corners, [&](std::uint32_t corner) {
                return isFinite(scene.vertices[corner].position);
            }))
            continue;
        std::ranges::copy(corners, scene.indices.begin() + 3 * static_cast<std::ptrdiff_t>(next));
        ++next;
    }
    kept[triangles] = next;
    scene.indices.resize(3 * static_cast<std::size_t>(next));
    scene.repairs.badTriangles += triangles - next;
    for (MeshNode& node : scene.nodes)
        for (MeshPart& part : node.parts) {
            const std::uint32_t first = kept[part.firstIndex / 3];
            const std::uint32_t last = kept[(part.firstIndex + part.indexCount) / 3];
            part = {3 * first, 3 * (last - first), part.material};
        }
}

/// Sums over the faces around every place, weighted by area.
std::vector<glm::dvec3> faceNormals(const MeshDraft& draft) {
    const MeshScene& scene = draft.scene;
    std::vector<glm::dvec3> sums(scene.vertices.size(), glm::dvec3(0));
    const auto place = [&](std::uint32_t vertex) {
        return draft.places.empty() ? vertex : draft.places[vertex];
    };
    for (std::size_t i = 0; i < scene.indices.size(); i += 3) {
        const auto at = [&](std::size_t corner) {
            return glm::dvec3(scene.vertices[scene.indices[i + corner]].position);
        };
        const glm::dvec3 normal = glm::cross(at(1) - at(0), at(2) - at(0));
        for (std::size_t corner = 0; corner < 3; ++corner)
            sums[place(scene.indices[i + corner])] += normal;
    }
    return sums;
}

void mendNormals(MeshDraft& draft) {
    const std::vector<glm::dvec3> sums = faceNormals(draft);
    for (std::size_t i = 0; i < draft.scene.vertices.size(); ++i) {
        glm::vec3& normal = draft.scene.vertices[i].normal;
        const glm::dvec3 given = normal;
        const bool usable = isFinite(normal) && glm::dot(given, given) > 0;
        if (!usable && normal != glm::vec3(0)) ++draft.scene.repairs.badNormals;
        const glm::dvec3 made = sums[draft.places.empty() ? i : draft.places[i]];
        const double length = glm::length(made);
        if (usable)
            normal = glm::normalize(given);
        else
            normal = length > 0 ? glm::vec3(made / length) : glm::vec3(0, 0, 1);
    }
}

} // namespace

void note(MeshRepairs& repairs, const std::string& why) {
    constexpr std::size_t kMost = 8;
    if (repairs.why.size() < kMost) repairs.why.push_back(why);
}

MeshScene finished(MeshDraft draft) {
    MeshScene& scene = draft.scene;
    dropBadTriangles(scene);
    if (scene.triangles() == 0)
        throw DeviceError(scene.repairs.badTriangles > 0
                              ? "none of its triangles has finite corners"
                              : "it has no triangles");
    for (MeshVertex& vertex : scene.vertices) {
        if (!isFinite(vertex.position)) vertex.position = glm::vec3(0); // of no triangle any more
        if (std::isfinite(vertex.uv.x) && std::isfinite(vertex.uv.y)) continue;
        vertex.uv = glm::vec2(0);
        ++scene.repairs.badUvs;
    }
    mendNormals(draft);
    if (scene.repairs.badTriangles > 0)
        note(scene.repairs, std::to_string(scene.repairs.badTriangles) +
                                " triangles without finite corners left out");
    if (scene.repairs.badNormals > 0)
        note(scene.repairs, std::to_string(scene.repairs.badNormals) + " normals replaced");
    if (scene.repairs.badUvs > 0)
        note(scene.repairs, std::to_string(scene.repairs.badUvs) + " texture coordinates set to 0");
    return std::move(scene);
}

} // namespace autostereo::devices::mesh
