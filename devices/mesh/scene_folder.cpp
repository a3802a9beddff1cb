#include "devices/mesh/scene_folder.hpp"

#include "devices/input.hpp"
#include "devices/replay/image_files.hpp"

#include <algorithm>
#include <utility>

namespace autostereo::devices::mesh {

namespace {

namespace fs = std::filesystem;

/// Where `name` leads, symbolic links followed; empty: out of the folder.
fs::path inside(const fs::path& folder, const std::string& name) {
    if (name.empty() || name.find('\0') != std::string::npos || fs::path(name).is_absolute())
        return {};
    std::error_code error;
    const fs::path root = fs::canonical(folder.empty() ? fs::path(".") : folder, error);
    if (error) return {};
    const fs::path full = fs::weakly_canonical(root / name, error);
    if (error) return {};
    const auto [mismatch, rest] = std::mismatch(root.begin(), root.end(), full.begin(), full.end());
    return mismatch == root.end() ? full : fs::path{};
}

/// 16 bits become 8, grey becomes three equal colours.
std::vector<std::byte> rgbaFromGrey16(const std::vector<std::byte>& grey) {
    std::vector<std::byte> rgba(2 * grey.size());
    for (std::size_t i = 0; 2 * i < grey.size(); ++i) {
        const std::byte high = grey[2 * i + 1]; // host-endian, and the hosts are little-endian
        std::fill_n(rgba.begin() + 4 * static_cast<std::ptrdiff_t>(i), 3, high);
        rgba[4 * i + 3] = std::byte{255};
    }
    return rgba;
}

template<class Decoder>
void decode(MeshScene& scene, std::span<const std::byte> bytes, const MeshLimits& limits) {
    Decoder decoder;
    const ImageHeader header = decoder.open(bytes);
    const std::size_t rgbaBytes =
        4 * static_cast<std::size_t>(header.width) * static_cast<std::size_t>(header.height);
    std::size_t before = 0;
    for (const MeshTexture& texture : scene.textures)
        before += texture.rgba.size();
    if (!header.sizeAllowed() || rgbaBytes > limits.textureBytes - before)
        throw DeviceError("a texture of " + header.size().text() + " is too much (allowed " +
                          std::to_string(limits.textureBytes >> 20U) + " MiB for all)");
    MeshTexture texture{header.width, header.height, std::vector<std::byte>(header.bytes())};
    decoder.decode(texture.rgba);
    if (header.format == ImageFormat::Grey16) texture.rgba = rgbaFromGrey16(texture.rgba);
    scene.textures.push_back(std::move(texture));
}

} // namespace

std::vector<std::byte> SceneFolder::readScene() const { return readFile(file_, limits_.fileBytes); }

std::vector<std::byte> SceneFolder::read(const std::string& name) const {
    const fs::path path = inside(file_.parent_path(), name);
    if (path.empty()) throw DeviceError("'" + name + "' lies outside of the scene's folder");
    std::error_code error;
    if (!fs::is_regular_file(path, error)) throw DeviceError("'" + name + "' is no file there");
    return readFile(path, limits_.fileBytes);
}

int addTexture(MeshScene& scene, std::span<const std::byte> bytes, const MeshLimits& limits) {
    if (scene.textures.size() >= limits.textures)
        throw DeviceError("more than " + std::to_string(limits.textures) + " textures");
    if (PngDecoder::recognises(bytes))
        decode<PngDecoder>(scene, bytes, limits);
    else if (bytes.size() > 2 && bytes[0] == std::byte{0xff} && bytes[1] == std::byte{0xd8})
        decode<JpegDecoder>(scene, bytes, limits);
    else
        throw DeviceError("a texture is no PNG and no JPEG");
    return static_cast<int>(scene.textures.size()) - 1;
}

} // namespace autostereo::devices::mesh
