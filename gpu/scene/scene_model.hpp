#pragma once

#include "devices/mesh/mesh_scene.hpp"
#include "gpu/gl/objects.hpp"

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace autostereo::gpu {

/// Texels of a part in shaders/scene_parts.glsl, in this order.
struct ScenePart {
    glm::mat4 toDisplay{1}; ///< the node's frame -> display space, metres
    glm::mat4 normals{1};   ///< the same for normals, any length
    glm::vec4 diffuse{0};   ///< w: shininess
    glm::vec4 specular{0};
    glm::vec4 emissive{0};

    static constexpr int kTexels = 11;
    static constexpr int kPerRow = 64; ///< of the texture of all parts
};
static_assert(sizeof(ScenePart) == 16 * ScenePart::kTexels);

/// A MeshScene on the GPU: vertices and textures once, nodes' places anew for every picture. Draws
/// itself with whatever program is in use. Thread-bound.
class SceneModel {
  public:
    /// Throws GlError where the driver has not the memory or allows no texture of that size.
    explicit SceneModel(const devices::mesh::MeshScene& scene);

    /// Puts nodes where they are at a time, in display space by `toDisplay`.
    void place(const devices::mesh::MeshScene& scene, double seconds, const glm::dmat4& toDisplay);
    /// Every part, `instances` times each.
    void draw(int instances) const;

    /// For shaders/scene_parts.glsl.
    [[nodiscard]] const gl::Texture& parts() const { return partTexels_; }

  private:
    struct Draw {
        GLsizei indexCount;
        std::size_t firstIndex;
        int node, material, texture;
    };
    void upload(const devices::mesh::MeshScene& scene);
    void describeVertices();

    std::vector<Draw> draws_;
    std::vector<ScenePart> parts_;
    gl::Buffer vertices_, indices_, numbers_;
    gl::Texture partTexels_; ///< RGBA32F
    gl::VertexArray vertexArray_;
    std::vector<gl::Texture> textures_; ///< sRGB; the last one is a white texel
};

} // namespace autostereo::gpu
