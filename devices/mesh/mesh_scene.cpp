#include "devices/mesh/mesh_scene.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace autostereo::devices::mesh {

namespace {

glm::dquat quaternion(const glm::dvec4& value) {
    return glm::dquat(value.w, value.x, value.y, value.z);
}

glm::dvec4 sample(const MeshChannel& channel, double seconds) {
    const auto next = std::upper_bound(channel.seconds.begin(), channel.seconds.end(), seconds);
    if (next == channel.seconds.begin()) return channel.values.front();
    if (next == channel.seconds.end()) return channel.values.back();
    const auto at = static_cast<std::size_t>(next - channel.seconds.begin());
    const glm::dvec4 from = channel.values[at - 1], to = channel.values[at];
    if (channel.between == MeshChannel::Between::Step) return from;
    const double share = (seconds - channel.seconds[at - 1]) /
                         (static_cast<double>(*next) - channel.seconds[at - 1]);
    if (channel.path != MeshChannel::Path::Rotation) return glm::mix(from, to, share);
    const glm::dquat turned = glm::slerp(quaternion(from), quaternion(to), share);
    return {turned.x, turned.y, turned.z, turned.w};
}

void put(MeshPose& pose, const MeshChannel& channel, double seconds) {
    const glm::dvec4 value = sample(channel, seconds);
    switch (channel.path) {
    case MeshChannel::Path::Translation:
        pose.translation = value;
        break;
    case MeshChannel::Path::Rotation:
        if (glm::length(value) > 0) pose.rotation = glm::normalize(quaternion(value));
        break;
    case MeshChannel::Path::Scale:
        pose.scale = value;
        break;
    }
}

template<class Receive>
void forEachCorner(const MeshScene& scene, const glm::dmat3& turn, Receive receive) {
    constexpr int kMoments = 16;
    for (int moment = 0; moment < (scene.periodS > 0 ? kMoments : 1); ++moment) {
        const std::vector<glm::dmat4> ways = scene.transforms(scene.periodS * moment / kMoments);
        for (std::size_t node = 0; node < scene.nodes.size(); ++node) {
            const glm::dmat4 way = glm::dmat4(turn) * ways[node];
            for (const MeshPart& part : scene.nodes[node].parts)
                for (std::size_t at = 0; at < part.indexCount; ++at) {
                    const auto& vertex = scene.vertices[scene.indices[part.firstIndex + at]];
                    receive(glm::dvec3(way * glm::dvec4(vertex.position, 1)));
                }
        }
    }
}

} // namespace

glm::dmat4 MeshPose::transform() const {
    if (matrix) return *matrix;
    return glm::translate(glm::dmat4(1), translation) * glm::mat4_cast(rotation) *
           glm::scale(glm::dmat4(1), scale);
}

std::size_t MeshScene::triangles() const {
    std::size_t drawn = 0;
    for (const MeshNode& node : nodes)
        for (const MeshPart& part : node.parts)
            drawn += part.indexCount / 3;
    return drawn;
}

std::vector<glm::dmat4> MeshScene::transforms(double seconds) const {
    std::vector<MeshPose> poses;
    poses.reserve(nodes.size());
    for (const MeshNode& node : nodes)
        poses.push_back(node.pose);
    const double at = periodS > 0 ? seconds - periodS * std::floor(seconds / periodS) : 0;
    for (const MeshChannel& channel : channels)
        put(poses[static_cast<std::size_t>(channel.node)], channel, at);
    std::vector<glm::dmat4> ways;
    ways.reserve(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const glm::dmat4 own = poses[i].transform();
        const int parent = nodes[i].parent;
        ways.push_back(parent == kNone ? own : ways[static_cast<std::size_t>(parent)] * own);
    }
    return ways;
}

MeshExtent extent(const MeshScene& scene, const glm::dmat3& turn) {
    MeshExtent all;
    forEachCorner(scene, turn, [&](const glm::dvec3& place) {
        all.low = glm::min(all.low, place);
        all.high = glm::max(all.high, place);
    });
    const glm::dvec3 middle = all.middle();
    forEachCorner(scene, turn, [&](const glm::dvec3& place) {
        all.around = std::max(all.around, std::hypot(place.x - middle.x, place.z - middle.z));
    });
    return all;
}

} // namespace autostereo::devices::mesh
