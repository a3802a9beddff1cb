#pragma once

#include "devices/mesh/gltf_json.hpp"
#include "devices/mesh/mesh_scene.hpp"

#include <vector>

namespace autostereo::devices::mesh {

struct GltfNodes {
    std::vector<MeshNode> nodes; ///< parents first, without parts
    std::vector<int> meshes;     ///< each one's mesh in the document, or kNone
    std::vector<int> places;     ///< for each node of the document its place in `nodes`, or kNone
};

/// The nodes of the document's scene. Throws DeviceError where they are no tree.
[[nodiscard]] GltfNodes readGltfNodes(const Json& document, const MeshLimits& limits);

} // namespace autostereo::devices::mesh
