#pragma once

#include "config/config.hpp"
#include "devices/mesh/mesh_scene.hpp"

namespace autostereo::daemon {

/// Whether the input is a scene of triangles (FILE.glb, .gltf, .obj, .ply) and no camera.
[[nodiscard]] bool isScene(const config::Config& config);

/// Reads it; what was repaired goes to the log. Throws DeviceError.
[[nodiscard]] devices::mesh::MeshScene openMeshScene(const std::string& file);

/// Pictures a second where none are timed: frames of `render`, and of `run --speed max`.
constexpr double kSceneRate = 30;

/// Whether it looks otherwise from one moment to the next.
[[nodiscard]] bool sceneMoves(const config::Config& config, const devices::mesh::MeshScene& scene);

/// How it is shown: [scene], and of [depth] and [picture] what bears on depth.
[[nodiscard]] gpu::SceneParams sceneParams(const config::Config& config);

} // namespace autostereo::daemon
