#include "devices/mesh/gltf_animation.hpp"

#include <algorithm>
#include <cmath>

namespace autostereo::devices::mesh {

namespace {

std::optional<MeshChannel::Path> pathOf(const std::string& path) {
    if (path == "translation") return MeshChannel::Path::Translation;
    if (path == "rotation") return MeshChannel::Path::Rotation;
    if (path == "scale") return MeshChannel::Path::Scale;
    return std::nullopt;
}

void readKeys(const Json& sampler, const GltfBuffers& buffers, std::size_t most,
              MeshChannel& channel) {
    constexpr float kLargest = 1e18F;
    const std::string between = text(sampler, "interpolation");
    const bool isSpline = between == "CUBICSPLINE";
    if (between == "STEP") channel.between = MeshChannel::Between::Step;
    const GltfValues times = buffers.values(whole(sampler, "input", 1'000'000), most);
    const GltfValues values = buffers.values(whole(sampler, "output", 1'000'000), 3 * most);
    const std::size_t components = channel.path == MeshChannel::Path::Rotation ? 4 : 3;
    const std::size_t apiece = isSpline ? 3 : 1; // in-tangent, value, out-tangent
    if (times.components != 1 || values.components != components ||
        values.count != apiece * times.count || times.count == 0)
        throw DeviceError("an animation's input and output do not fit");
    for (std::size_t i = 0; i < times.count; ++i) {
        const float second = times.values[i];
        if (!(second >= (i == 0 ? 0 : channel.seconds.back())) || !(second <= 1e6F))
            throw DeviceError("an animation's times do not rise from 0 to 1e6 s");
        channel.seconds.push_back(second);
        const float* const first = &values.values[components * (i * apiece + apiece / 2)];
        glm::dvec4 value{0};
        for (std::size_t c = 0; c < components; ++c) {
            if (!(std::abs(first[c]) <= kLargest))
                throw DeviceError("an animation's values are not finite");
            value[static_cast<int>(c)] = first[c];
        }
        channel.values.push_back(value);
    }
}

} // namespace

void readGltfAnimation(const MeshFile& file, const Json& document, const GltfBuffers& buffers,
                       const std::vector<int>& places, MeshScene& scene) {
    const Json& animations = list(document, "animations", 65'536);
    if (animations.empty()) return;
    const Json& samplers = list(animations[0], "samplers", 65'536);
    std::size_t keys = 0;
    for (const Json& given : list(animations[0], "channels", 65'536)) {
        const Json* target = member(given, "target");
        if (target == nullptr || member(*target, "node") == nullptr) continue;
        const auto path = pathOf(text(*target, "path"));
        const int node = places[whole(*target, "node", places.size())];
        // Nodes of other scenes, and those whose matrix nothing takes apart.
        if (!path || node == kNone || scene.nodes[static_cast<std::size_t>(node)].pose.matrix)
            continue;
        MeshChannel channel;
        channel.node = node;
        channel.path = *path;
        readKeys(samplers[whole(given, "sampler", samplers.size())], buffers,
                 file.limits.keys - keys, channel);
        keys += channel.seconds.size();
        scene.periodS = std::max<double>(scene.periodS, channel.seconds.back());
        scene.channels.push_back(std::move(channel));
    }
}

} // namespace autostereo::devices::mesh
