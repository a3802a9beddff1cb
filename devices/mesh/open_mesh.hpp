#pragma once

#include "devices/mesh/mesh_scene.hpp"

#include <filesystem>
#include <string>

namespace autostereo::devices::mesh {

/// Whether a file's name says that it holds a scene: .obj, .ply, .gltf, .glb, in either case.
[[nodiscard]] bool isMeshFile(const std::filesystem::path& file);

/// Reads a scene, with the files beside it that it names. Throws DeviceError, one line; memory
/// stays within a few times the limits whatever the file says. Reentrant.
[[nodiscard]] MeshScene openMesh(const std::filesystem::path& file, const MeshLimits& limits = {});

/// For people: "968 triangles, 2 materials, 1 texture".
[[nodiscard]] std::string describe(const MeshScene& scene);

} // namespace autostereo::devices::mesh
