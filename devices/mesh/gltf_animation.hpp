#pragma once

#include "devices/mesh/gltf_buffers.hpp"

#include <vector>

namespace autostereo::devices::mesh {

/// The document's first animation: moves, turns and scales nodes. Cubic splines are played as lines
/// between their keys; weights of morph targets are passed over. `places`: as in GltfNodes. Throws
/// DeviceError.
void readGltfAnimation(const MeshFile& file, const Json& document, const GltfBuffers& buffers,
                       const std::vector<int>& places, MeshScene& scene);

} // namespace autostereo::devices::mesh
