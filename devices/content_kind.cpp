#include "devices/content_kind.hpp"

#include "devices/quilt_name.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <utility>

namespace autostereo::devices {

namespace {

constexpr std::array<std::pair<std::string_view, ContentKind>, 9> kKinds{
    {{".png", ContentKind::Picture},
     {".jpg", ContentKind::Picture},
     {".jpeg", ContentKind::Picture},
     {".mkv", ContentKind::Recording},
     {".oni", ContentKind::Recording},
     {".glb", ContentKind::Scene},
     {".gltf", ContentKind::Scene},
     {".obj", ContentKind::Scene},
     {".ply", ContentKind::Scene}}};

} // namespace

std::string extensionOf(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char letter) {
        return static_cast<char>(std::tolower(letter));
    });
    return extension;
}

std::optional<ContentKind> contentKind(const std::filesystem::path& file) {
    const std::string extension = extensionOf(file);
    const auto* const known =
        std::ranges::find(kKinds, extension, [](const auto& kind) { return kind.first; });
    if (known == kKinds.end()) return std::nullopt;
    const bool quilt =
        known->second == ContentKind::Picture && quiltName(file.filename().string()).has_value();
    return quilt ? ContentKind::Quilt : known->second;
}

} // namespace autostereo::devices
