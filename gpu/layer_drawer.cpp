#include "gpu/layer_drawer.hpp"

namespace autostereo::gpu {

LayerDrawer::LayerDrawer(const DepthMeshParams& params)
    : vertexArray_(gl::makeVertexArray()),
      // Measured along the depth camera's axis; the colour camera may see it somewhat nearer.
      nearestZ_(static_cast<float>(params.nearestM / 10)) {}

void LayerDrawer::draw(const DepthMesh& mesh, const gl::Texture& color, glm::ivec4 tiles,
                       int instances) {
    glBindTextureUnit(2, color.name());
    drawLayer(mesh.scene(), tiles, {0.0F, 0.5F}, instances);
    drawLayer(mesh.background(), tiles, {0.5F, 0.5F}, instances);
}

void LayerDrawer::drawScene(const DepthMesh& mesh) {
    drawLayer(mesh.scene(), {1, 1, 0, 0}, {0.0F, 1.0F}, 1);
}

void LayerDrawer::drawLayer(const MeshLayer& layer, glm::ivec4 tiles, glm::vec2 depthRange,
                            int instances) {
    tiles.w = layer.points.width();
    uniforms_.bind(1, {tiles, {nearestZ_, depthRange.x, depthRange.y, 0}});
    glBindTextureUnit(0, layer.points.name());
    glBindTextureUnit(1, layer.sources.name());
    glVertexArrayElementBuffer(vertexArray_.name(), layer.indices.name());
    glBindVertexArray(vertexArray_.name());
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDrawElementsInstanced(GL_TRIANGLES, layer.indexCount, GL_UNSIGNED_INT, nullptr, instances);
    glDisable(GL_DEPTH_TEST);
}

} // namespace autostereo::gpu
