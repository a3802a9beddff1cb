#pragma once

#include "devices/mesh/mesh_scene.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace autostereo::devices::mesh {

/// What a reader has gathered, as it came: `finished` makes a scene of it. A normal of length 0
/// means that the file gave none. Indices are in range already.
struct MeshDraft {
    MeshScene scene;
    /// For each vertex, which place it stands at: those of one place share a normal where the file
    /// gives none. Empty: each vertex is a place.
    std::vector<std::uint32_t> places;
};

/// Leaves out triangles that are nowhere, makes normals where there are none (of all faces around,
/// by area), counts what it repaired. Throws DeviceError where no triangle is left.
[[nodiscard]] MeshScene finished(MeshDraft draft);

/// Notes why something was repaired; of many only the first few.
void note(MeshRepairs& repairs, const std::string& why);

} // namespace autostereo::devices::mesh
