#pragma once

#include "devices/mesh/gltf_buffers.hpp"

namespace autostereo::devices::mesh {

/// Metallic-roughness as Blinn-Phong. With base colour c, metallic m, roughness r:
///   diffuse   = c (1 - m/2): half of a metal's colour stands for surroundings that nothing shows;
///   shininess = 2/r^4 - 2, the exponent whose lobe is as wide as roughness r's (Walter 2007,
///               alpha = r^2), at most kMostShininess;
///   specular  = f (shininess + 8)/8 with f = 0.04 (1 - m) + c m, at most 1: the lobe's peak
///   against
///               diffuse light's.
/// Only the base colour's texture is used. A texture that cannot be had is left out and counted.
void readGltfMaterials(const MeshFile& file, const Json& document, const GltfBuffers& buffers,
                       MeshScene& scene);

/// The rule by itself.
[[nodiscard]] MeshMaterial blinnPhong(const glm::vec3& base, float metallic, float roughness);

} // namespace autostereo::devices::mesh
