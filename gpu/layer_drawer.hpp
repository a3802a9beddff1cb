#pragma once

#include "gpu/blocks.hpp"
#include "gpu/gl/uniform_buffer.hpp"
#include "gpu/mesh_layer.hpp"
#include "gpu/params.hpp"

#include <array>

namespace autostereo::gpu {

/// Draws mesh layers with whatever program is in use: the scene in front, the background
/// behind it in a depth range of its own. Shared by every pass that draws the mesh. Thread-bound.
class LayerDrawer {
  public:
    explicit LayerDrawer(const DepthMeshParams& params);

    /// Scene and background. `tiles`: see shaders/views_block.glsl (its .w is set here).
    void draw(const MeshLayers& layers, const gl::Texture& color, glm::ivec4 tiles, int instances);
    /// Measured surfaces only.
    void drawScene(const MeshLayer& scene);
    /// Of these, what `indices` name and `command` counts (glDrawElementsIndirect).
    void drawPart(const MeshLayer& scene, const gl::Buffer& indices, const gl::Buffer& command);

    /// Binds a target for drawing parts of layers into, and that there are no attributes.
    void target(GLuint framebuffer) const;
    /// Binds and clears a target for drawing layers into.
    static void clear(GLuint framebuffer, const std::array<double, 3>& color);

  private:
    void bindLayer(const MeshLayer& layer, glm::ivec4 tiles, glm::vec2 depthRange);
    void drawLayer(const MeshLayer& layer, glm::ivec4 tiles, glm::vec2 depthRange, int instances);

    gl::UniformBuffer<ViewsBlock> uniforms_;
    gl::VertexArray vertexArray_; ///< no attributes: shaders fetch their node by its number
    float nearestZ_;
};

} // namespace autostereo::gpu
