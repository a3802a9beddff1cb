#include "devices/mesh/gltf_nodes.hpp"

#include <glm/geometric.hpp>

#include <deque>

namespace autostereo::devices::mesh {

namespace {

/// `Count` finite numbers, or nothing where there are none.
template<std::size_t Count>
std::optional<std::array<double, Count>> numbers(const Json& node, const char* key) {
    if (member(node, key) == nullptr) return std::nullopt;
    const Json& given = list(node, key, Count);
    if (given.size() != Count)
        throw DeviceError(std::string(key) + " has not " + std::to_string(Count) + " numbers");
    std::array<double, Count> read{};
    constexpr double kLargest = 1e18; // products of a chain of them stay finite, or are refused
    for (std::size_t i = 0; i < Count; ++i) {
        if (!given[i].is_number() || !(std::abs(given[i].get<double>()) <= kLargest))
            failAt(key, given[i], "numbers up to 1e18");
        read[i] = given[i].get<double>();
    }
    return read;
}

MeshPose poseOf(const Json& node) {
    MeshPose pose;
    if (const auto m = numbers<16>(node, "matrix")) {
        glm::dmat4 matrix(1);
        for (int i = 0; i < 16; ++i)
            matrix[i / 4][i % 4] = (*m)[static_cast<std::size_t>(i)];
        pose.matrix = matrix;
    }
    if (const auto t = numbers<3>(node, "translation"))
        pose.translation = {(*t)[0], (*t)[1], (*t)[2]};
    if (const auto s = numbers<3>(node, "scale")) pose.scale = {(*s)[0], (*s)[1], (*s)[2]};
    if (const auto r = numbers<4>(node, "rotation")) {
        const glm::dquat turn((*r)[3], (*r)[0], (*r)[1], (*r)[2]);
        if (glm::length(turn) > 0) pose.rotation = glm::normalize(turn);
    }
    return pose;
}

std::vector<std::size_t> roots(const Json& document, std::size_t nodeCount) {
    const Json& scenes = list(document, "scenes", nodeCount + 65'536);
    std::vector<std::size_t> found;
    if (scenes.empty()) { // then all that nobody is parent of
        std::vector<bool> isChild(nodeCount, false);
        const Json& nodes = list(document, "nodes", nodeCount);
        for (const Json& node : nodes)
            for (const Json& child : list(node, "children", nodeCount))
                if (child.is_number_unsigned() && child.get<std::size_t>() < nodeCount)
                    isChild[child.get<std::size_t>()] = true;
        for (std::size_t i = 0; i < nodeCount; ++i)
            if (!isChild[i]) found.push_back(i);
        return found;
    }
    const Json& scene = scenes[whole(document, "scene", scenes.size(), 0)];
    for (const Json& root : list(scene, "nodes", nodeCount)) {
        if (!root.is_number_unsigned() || root.get<std::size_t>() >= nodeCount)
            failAt("scene.nodes", root, "below " + std::to_string(nodeCount));
        found.push_back(root.get<std::size_t>());
    }
    return found;
}

} // namespace

GltfNodes readGltfNodes(const Json& document, const MeshLimits& limits) {
    const Json& nodes = list(document, "nodes", limits.nodes);
    const std::size_t meshCount = list(document, "meshes", 1'000'000).size();
    GltfNodes read;
    read.places.assign(nodes.size(), kNone);
    struct Visit {
        std::size_t node;
        int parent;
    };
    std::deque<Visit> open;
    for (const std::size_t root : roots(document, nodes.size()))
        open.push_back({root, kNone});
    while (!open.empty()) {
        const Visit visit = open.front();
        open.pop_front();
        const Json& node = nodes[visit.node];
        if (read.places[visit.node] != kNone)
            throw DeviceError("node " + std::to_string(visit.node) +
                              " has two parents or is its own");
        const int place = static_cast<int>(read.nodes.size());
        read.places[visit.node] = place;
        read.nodes.push_back({text(node, "name"), visit.parent, poseOf(node), {}});
        const bool draws = member(node, "mesh") != nullptr;
        read.meshes.push_back(draws ? static_cast<int>(whole(node, "mesh", meshCount)) : kNone);
        for (const Json& child : list(node, "children", nodes.size())) {
            if (!child.is_number_unsigned() || child.get<std::size_t>() >= nodes.size())
                failAt("children", child, "below " + std::to_string(nodes.size()));
            open.push_back({child.get<std::size_t>(), place});
        }
    }
    return read;
}

} // namespace autostereo::devices::mesh
