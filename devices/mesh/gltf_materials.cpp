#include "devices/mesh/gltf_materials.hpp"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>

namespace autostereo::devices::mesh {

namespace {

constexpr std::size_t kMostMaterials = 65'536;

glm::vec3 color(const Json& object, const char* key, float absent, float most) {
    glm::vec3 read{absent};
    const Json& given = list(object, key, 4);
    for (std::size_t i = 0; i < std::min<std::size_t>(3, given.size()); ++i) {
        if (!given[i].is_number()) failAt(key, given[i], "numbers");
        read[static_cast<int>(i)] =
            static_cast<float>(std::clamp(given[i].get<double>(), 0.0, double{most}));
    }
    return read;
}

class MaterialsReader {
  public:
    MaterialsReader(const MeshFile& file, const Json& document, const GltfBuffers& buffers,
                    MeshScene& scene)
        : file_(file), document_(document), buffers_(buffers), scene_(scene) {}

    [[nodiscard]] MeshMaterial read(const Json& material) {
        constexpr float kBrightest = 16;
        static const Json none = Json::object();
        const Json* given = member(material, "pbrMetallicRoughness");
        const Json& surface = given == nullptr ? none : *given;
        const auto share = [&](const char* key) {
            return static_cast<float>(std::clamp(number(surface, key, 1), 0.0, 1.0));
        };
        MeshMaterial read = blinnPhong(color(surface, "baseColorFactor", 1, 1),
                                       share("metallicFactor"), share("roughnessFactor"));
        read.name = text(material, "name");
        read.emissive = color(material, "emissiveFactor", 0, kBrightest);
        if (const Json* picture = member(surface, "baseColorTexture"))
            read.texture = texture(whole(*picture, "index", kMostMaterials));
        return read;
    }

  private:
    int texture(std::size_t index) {
        const auto known = textures_.find(index);
        if (known != textures_.end()) return known->second;
        int added = kNone;
        try {
            added = addTexture(scene_, bytes(index), file_.limits);
        } catch (const std::exception& error) {
            ++scene_.repairs.textures;
            note(scene_.repairs, "texture " + std::to_string(index) + " left out: " + error.what());
        }
        textures_[index] = added;
        return added;
    }
    [[nodiscard]] std::vector<std::byte> bytes(std::size_t index) const {
        const Json& image = list(document_, "images", kMostMaterials)
                                .at(whole(list(document_, "textures", kMostMaterials).at(index),
                                          "source", kMostMaterials));
        const std::string uri = text(image, "uri");
        if (!uri.empty()) return buffers_.fetch(uri);
        const auto view = buffers_.view(whole(image, "bufferView", kMostMaterials * 16));
        return {view.begin(), view.end()};
    }

    const MeshFile& file_;
    const Json& document_;
    const GltfBuffers& buffers_;
    MeshScene& scene_;
    std::map<std::size_t, int> textures_;
};

} // namespace

MeshMaterial blinnPhong(const glm::vec3& base, float metallic, float roughness) {
    constexpr float kDielectric = 0.04F, kSmoothest = 0.01F;
    MeshMaterial material;
    material.diffuse = base * (1 - metallic / 2);
    const float width = std::pow(std::max(roughness, kSmoothest), 4.0F);
    material.shininess = std::clamp(2 / width - 2, 0.0F, kMostShininess);
    const glm::vec3 facing = glm::mix(glm::vec3(kDielectric), base, metallic);
    material.specular = glm::min(facing * (material.shininess + 8) / 8.0F, glm::vec3(1));
    return material;
}

void readGltfMaterials(const MeshFile& file, const Json& document, const GltfBuffers& buffers,
                       MeshScene& scene) {
    MaterialsReader reader(file, document, buffers, scene);
    for (const Json& material : list(document, "materials", file.limits.materials))
        scene.materials.push_back(reader.read(material));
}

} // namespace autostereo::devices::mesh
