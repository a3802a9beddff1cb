#pragma once

#include "gpu/blocks.hpp"
#include "gpu/depth_mesh.hpp"
#include "gpu/gl/uniform_buffer.hpp"

namespace autostereo::gpu {

/// Draws a DepthMesh's layers with whatever program is in use: the scene in front, the background
/// behind it in a depth range of its own. Shared by every pass that draws the mesh. Thread-bound.
class LayerDrawer {
  public:
    explicit LayerDrawer(const DepthMeshParams& params);

    /// Scene and background. `tiles`: see shaders/views_block.glsl (its .w is set here).
    void draw(const DepthMesh& mesh, const gl::Texture& color, glm::ivec4 tiles, int instances);
    /// Measured surfaces only.
    void drawScene(const DepthMesh& mesh);

  private:
    void drawLayer(const MeshLayer& layer, glm::ivec4 tiles, glm::vec2 depthRange, int instances);

    gl::UniformBuffer<ViewsBlock> uniforms_;
    gl::VertexArray vertexArray_; ///< no attributes: shaders fetch their node by its number
    float nearestZ_;
};

} // namespace autostereo::gpu
