#include "devices/mesh/mtl_reader.hpp"

#include "devices/mesh/text_lines.hpp"

#include <algorithm>
#include <cmath>
#include <exception>

namespace autostereo::devices::mesh {

namespace {

float light(float screen) { // IEC 61966-2-1
    return screen <= 0.04045F ? screen / 12.92F : std::pow((screen + 0.055F) / 1.055F, 2.4F);
}

class MtlReader {
  public:
    MtlReader(const MeshFile& file, TextLines lines, MeshScene& scene,
              std::map<std::string, int, std::less<>>& materials)
        : file_(file), lines_(std::move(lines)), scene_(scene), materials_(materials) {}

    void read() {
        while (lines_.next()) {
            const std::string_view key = lines_.word();
            if (key == "newmtl")
                begin(std::string(lines_.remainder()));
            else if (material_ != kNone)
                readValue(key);
        }
    }

  private:
    [[nodiscard]] MeshMaterial& material() {
        return scene_.materials[static_cast<std::size_t>(material_)];
    }
    void begin(const std::string& name) {
        allow(scene_.materials.size() + 1, file_.limits.materials, "materials");
        material_ = static_cast<int>(scene_.materials.size());
        scene_.materials.push_back({.name = name});
        materials_.insert_or_assign(name, material_);
    }
    void readValue(std::string_view key) {
        if (key == "Kd") color(material().diffuse);
        if (key == "Ks") color(material().specular);
        if (key == "Ke") color(material().emissive);
        if (key == "Ns") shininess();
        if (key == "map_Kd") texture();
    }
    void color(glm::vec3& value) {
        glm::vec3 read{0};
        for (int channel = 0; channel < 3; ++channel) {
            const auto number = lines_.optionalNumber("color");
            if (!number && channel == 0) return repair(); // spectral curves and the like
            read[channel] = number.value_or(read[0]);
            if (!std::isfinite(read[channel])) return repair();
        }
        for (int channel = 0; channel < 3; ++channel)
            value[channel] = light(std::clamp(read[channel], 0.0F, 1.0F));
    }
    void shininess() {
        const float value = lines_.number("Ns");
        if (!std::isfinite(value)) return repair();
        material().shininess = std::clamp(value, 0.0F, kMostShininess);
    }
    void repair() { ++scene_.repairs.badMaterials; }
    /// Options before the name are passed over: a name is what comes last.
    void texture() {
        std::string name(lines_.remainder());
        if (name.starts_with('-')) name.erase(0, name.find_last_of(" \t") + 1);
        try {
            const auto known = textures_.find(name);
            if (known == textures_.end())
                textures_[name] = addTexture(scene_, file_.folder.read(name), file_.limits);
            material().texture = textures_[name];
        } catch (const std::exception& error) {
            textures_[name] = kNone;
            ++scene_.repairs.textures;
            note(scene_.repairs, "texture '" + name + "' left out: " + error.what());
        }
    }

    const MeshFile& file_;
    TextLines lines_;
    MeshScene& scene_;
    std::map<std::string, int, std::less<>>& materials_;
    std::map<std::string, int> textures_;
    int material_ = kNone;
};

} // namespace

void readMtl(const MeshFile& file, const std::string& name, MeshScene& scene,
             std::map<std::string, int, std::less<>>& materials) {
    try {
        const std::vector<std::byte> bytes = file.folder.read(name);
        MtlReader(file, TextLines(bytes, name), scene, materials).read();
    } catch (const std::exception& error) {
        ++scene.repairs.badMaterials;
        note(scene.repairs, std::string("materials left out: ") + error.what());
    }
}

} // namespace autostereo::devices::mesh
