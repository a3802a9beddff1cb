#pragma once

#include "devices/mesh/mesh_draft.hpp"
#include "devices/mesh/scene_folder.hpp"

#include <cstddef>
#include <span>
#include <string>

namespace autostereo::devices::mesh {

/// A file to be read: its bytes, its name for messages, and where what it names lies.
struct MeshFile {
    std::span<const std::byte> bytes;
    std::string name;
    const SceneFolder& folder;
    MeshLimits limits;
};

// One reader a format; all throw DeviceError (or what a JSON library throws) on the first thing
// that makes the rest meaningless, and leave the rest to `finished`.

/// Wavefront OBJ: v, vt, vn, f (any polygon, as a fan; numbers from the end), usemtl, mtllib.
/// Lines, points, curves, groups and smoothing groups are passed over.
[[nodiscard]] MeshDraft readObj(const MeshFile& file);
/// PLY 1.0: ascii, binary of either order. Vertices with x y z, nx ny nz, s t or u v; faces with
/// vertex_indices. Colours of vertices are passed over.
[[nodiscard]] MeshDraft readPly(const MeshFile& file);
/// glTF 2.0, text or binary.
[[nodiscard]] MeshDraft readGltf(const MeshFile& file);

/// Room for so many more, or DeviceError.
void allow(std::size_t count, std::size_t most, const char* what);

} // namespace autostereo::devices::mesh
