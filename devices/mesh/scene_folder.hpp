#pragma once

#include "devices/mesh/mesh_scene.hpp"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace autostereo::devices::mesh {

/// The folder of a scene's file, out of which nothing that the file names is read: what leaves it
/// (absolute, by `..`, by a link) or is no file there throws DeviceError. Reentrant.
class SceneFolder {
  public:
    SceneFolder(std::filesystem::path sceneFile, const MeshLimits& limits)
        : file_(std::move(sceneFile)), limits_(limits) {}

    /// The scene's own file.
    [[nodiscard]] std::vector<std::byte> readScene() const;
    /// A file that the scene names, relative to the folder.
    [[nodiscard]] std::vector<std::byte> read(const std::string& name) const;

  private:
    std::filesystem::path file_;
    MeshLimits limits_;
};

/// Decodes PNG or JPEG bytes and appends them to the scene, where its limits allow. The texture's
/// index. Throws std::runtime_error.
int addTexture(MeshScene& scene, std::span<const std::byte> bytes, const MeshLimits& limits);

} // namespace autostereo::devices::mesh
