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

MeshBounds bounds(const MeshScene& scene, double seconds) {
    MeshBounds box;
    const std::vector<glm::dmat4> ways = scene.transforms(seconds);
    for (std::size_t i = 0; i < scene.nodes.size(); ++i)
        for (const MeshPart& part : scene.nodes[i].parts)
            for (std::size_t at = 0; at < part.indexCount; ++at) {
                const glm::dvec3 own = scene.vertices[scene.indices[part.firstIndex + at]].position;
                const glm::dvec3 place = ways[i] * glm::dvec4(own, 1);
                box.low = glm::min(box.low, place);
                box.high = glm::max(box.high, place);
            }
    return box;
}

MeshBounds extent(const MeshScene& scene) {
    constexpr int kMoments = 16;
    MeshBounds box = bounds(scene, 0);
    for (int moment = 1; moment < kMoments && scene.periodS > 0; ++moment) {
        const MeshBounds then = bounds(scene, scene.periodS * moment / kMoments);
        box.low = glm::min(box.low, then.low);
        box.high = glm::max(box.high, then.high);
    }
    return box;
}

} // namespace autostereo::devices::mesh
