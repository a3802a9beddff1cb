#include "devices/mesh/gltf_animation.hpp"
#include "devices/mesh/gltf_buffers.hpp"
#include "devices/mesh/gltf_materials.hpp"
#include "devices/mesh/gltf_nodes.hpp"
#include "devices/mesh/readers.hpp"

#include <array>
#include <cstring>
#include <map>

namespace autostereo::devices::mesh {

namespace {

struct Container {
    std::span<const std::byte> json, chunk;
};

std::uint32_t wordAt(std::span<const std::byte> bytes, std::size_t at) {
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.data() + at, sizeof word);
    return word;
}

/// A .glb is a header of 12 bytes, then chunks: length, kind, bytes.
Container takenApart(std::span<const std::byte> bytes) {
    constexpr std::uint32_t kMagic = 0x46546c67, kJson = 0x4e4f534a, kBinary = 0x004e4942;
    if (bytes.size() < 4 || wordAt(bytes, 0) != kMagic) return {bytes, {}};
    Container container;
    std::size_t at = 12;
    while (bytes.size() >= at && bytes.size() - at >= 8) {
        const std::size_t length = wordAt(bytes, at);
        if (length > bytes.size() - at - 8) throw DeviceError("is cut off: a chunk is not whole");
        const auto content = bytes.subspan(at + 8, length);
        if (wordAt(bytes, at + 4) == kJson && container.json.empty()) container.json = content;
        if (wordAt(bytes, at + 4) == kBinary && container.chunk.empty()) container.chunk = content;
        at += 8 + length;
    }
    return container;
}

Json parsed(std::span<const std::byte> bytes, const MeshLimits& limits) {
    constexpr int kDeepest = 64;
    if (bytes.size() > limits.jsonBytes)
        throw DeviceError("a document of " + std::to_string(bytes.size()) + " bytes (allowed " +
                          std::to_string(limits.jsonBytes) + "; put meshes into a .bin or .glb)");
    const auto* const text = reinterpret_cast<const char*>(bytes.data());
    return Json::parse(text, text + bytes.size(), [](int depth, Json::parse_event_t, Json&) {
        if (depth > kDeepest) throw DeviceError("is nested too deeply");
        return true;
    });
}

void checkDocument(const Json& document) {
    const Json* asset = member(document, "asset");
    const std::string version = asset == nullptr ? "" : text(*asset, "version");
    if (!version.starts_with("2."))
        throw DeviceError("asset.version = '" + version.substr(0, 16) + "' (allowed 2.0)");
    for (const Json& extension : list(document, "extensionsRequired", kMostEntries))
        if (extension != "KHR_materials_unlit" && extension != "KHR_texture_transform")
            failAt("extensionsRequired", extension, "none that changes what meshes are");
}

/// Meshes -> vertices, indices and, for each mesh, the parts that draw it.
class MeshesReader {
  public:
    MeshesReader(const MeshFile& file, const Json& document, const GltfBuffers& buffers,
                 MeshScene& scene)
        : file_(file), document_(document), buffers_(buffers), scene_(scene) {}

    std::vector<MeshPart> parts(std::size_t meshIndex) {
        const auto known = meshes_.find(meshIndex);
        if (known != meshes_.end()) return known->second;
        const Json& mesh = list(document_, "meshes", kMostEntries).at(meshIndex);
        std::vector<MeshPart> parts;
        for (const Json& primitive : list(mesh, "primitives", file_.limits.parts)) {
            const auto part = read(primitive);
            if (part.indexCount > 0) parts.push_back(part);
        }
        meshes_[meshIndex] = parts;
        return parts;
    }

  private:
    MeshPart read(const Json& primitive) {
        const std::size_t mode = whole(primitive, "mode", 7, 4);
        const Json* attributes = member(primitive, "attributes");
        const auto start = static_cast<std::uint32_t>(scene_.indices.size());
        if (mode < 4 || attributes == nullptr) return {start, 0, 0}; // points and lines
        const std::size_t first = scene_.vertices.size();
        addVertices(*attributes);
        const std::size_t added = scene_.vertices.size() - first;
        addIndices(primitive, mode, first, added);
        const std::size_t material = whole(primitive, "material", scene_.materials.size() - 1,
                                           scene_.materials.size() - 1); // the last: the default
        return {start, static_cast<std::uint32_t>(scene_.indices.size()) - start,
                static_cast<int>(material)};
    }
    void addVertices(const Json& attributes) {
        const std::size_t first = scene_.vertices.size();
        const std::size_t most = file_.limits.vertices - first;
        const GltfValues places =
            buffers_.values(whole(attributes, "POSITION", kMostEntries), most);
        require(places, 3, "POSITION");
        scene_.vertices.resize(first + places.count, {.normal = glm::vec3(0)});
        const auto fill = [&](const GltfValues& from, auto put) {
            if (from.count != places.count) throw DeviceError("attributes of unequal count");
            for (std::size_t i = 0; i < from.count; ++i)
                put(scene_.vertices[first + i], &from.values[i * from.components]);
        };
        fill(places, [](MeshVertex& vertex, const float* value) {
            vertex.position = {value[0], value[1], value[2]};
        });
        if (const auto normals = attribute(attributes, "NORMAL", 3, most); normals.count > 0)
            fill(normals, [](MeshVertex& vertex, const float* value) {
                vertex.normal = {value[0], value[1], value[2]};
            });
        if (const auto uvs = attribute(attributes, "TEXCOORD_0", 2, most); uvs.count > 0)
            fill(uvs, [](MeshVertex& vertex, const float* value) {
                vertex.uv = {value[0], value[1]};
            });
    }
    [[nodiscard]] GltfValues attribute(const Json& attributes, const char* name,
                                       std::size_t components, std::size_t most) const {
        if (member(attributes, name) == nullptr) return {};
        GltfValues values = buffers_.values(whole(attributes, name, kMostEntries), most);
        require(values, components, name);
        return values;
    }
    static void require(const GltfValues& values, std::size_t components, const char* name) {
        if (values.components != components)
            throw DeviceError(std::string(name) + " is no VEC" + std::to_string(components));
    }
    void addIndices(const Json& primitive, std::size_t mode, std::size_t first, std::size_t added) {
        const std::size_t most = (file_.limits.indices - scene_.indices.size()) / 3;
        std::vector<std::uint32_t> order;
        if (member(primitive, "indices") != nullptr) {
            order = buffers_.indices(whole(primitive, "indices", kMostEntries), 3 * most);
        } else {
            allow(added, 3 * most, "indices");
            for (std::uint32_t i = 0; i < added; ++i)
                order.push_back(i);
        }
        for (const std::uint32_t index : order)
            if (index >= added)
                throw DeviceError("indices hold " + std::to_string(index) + " (allowed below " +
                                  std::to_string(added) + ")");
        const auto triangle = [&](std::size_t a, std::size_t b, std::size_t c) {
            for (const std::size_t corner : {a, b, c})
                scene_.indices.push_back(static_cast<std::uint32_t>(first) + order[corner]);
        };
        const bool isStrip = mode == 5, isFan = mode == 6;
        if (isStrip || isFan) allow(order.size(), most, "indices");
        const std::size_t step = isStrip || isFan ? 1 : 3;
        for (std::size_t i = 0; i + 2 < order.size(); i += step) {
            if (isFan)
                triangle(0, i + 1, i + 2);
            else if (isStrip && i % 2 == 1)
                triangle(i + 1, i, i + 2);
            else
                triangle(i, i + 1, i + 2);
        }
    }

    const MeshFile& file_;
    const Json& document_;
    const GltfBuffers& buffers_;
    MeshScene& scene_;
    std::map<std::size_t, std::vector<MeshPart>> meshes_;
};

} // namespace

MeshDraft readGltf(const MeshFile& file) {
    const Container container = takenApart(file.bytes);
    const Json document = parsed(container.json, file.limits);
    checkDocument(document);
    const GltfBuffers buffers(file, document, container.chunk);
    MeshDraft draft;
    readGltfMaterials(file, document, buffers, draft.scene);
    draft.scene.materials.push_back({.name = "default"});
    const GltfNodes nodes = readGltfNodes(document, file.limits);
    MeshesReader meshes(file, document, buffers, draft.scene);
    std::size_t parts = 0;
    for (std::size_t i = 0; i < nodes.nodes.size(); ++i) {
        draft.scene.nodes.push_back(nodes.nodes[i]);
        if (nodes.meshes[i] == kNone) continue;
        auto& drawn = draft.scene.nodes.back().parts;
        drawn = meshes.parts(static_cast<std::size_t>(nodes.meshes[i]));
        parts += drawn.size();
        allow(parts, file.limits.parts, "parts");
    }
    readGltfAnimation(file, document, buffers, nodes.places, draft.scene);
    return draft;
}

} // namespace autostereo::devices::mesh
