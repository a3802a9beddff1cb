#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace autostereo::devices {

/// What there is in a file to be shown.
enum class ContentKind {
    Picture,   ///< PNG, JPEG
    Quilt,     ///< the same, named as quilt_name.hpp says
    Recording, ///< of cameras: .mkv, .oni
    Scene      ///< of triangles: .glb, .gltf, .obj, .ply
};

/// By the file's name alone, which need not exist; nothing: none of these. Reentrant.
[[nodiscard]] std::optional<ContentKind> contentKind(const std::filesystem::path& file);

/// The names that `contentKind` knows, for messages.
constexpr const char* kContentNames = ".png, .jpg, .jpeg, quilts ..._qs8x6a0.75.png, .mkv, .oni, "
                                      ".glb, .gltf, .obj, .ply";

/// File name extension in lower case, with its dot.
[[nodiscard]] std::string extensionOf(const std::filesystem::path& file);

} // namespace autostereo::devices
