#include "gpu/layer_drawer.hpp"

namespace autostereo::gpu {

namespace {

void bindTarget(GLuint framebuffer) {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
}

} // namespace

LayerDrawer::LayerDrawer(const DepthMeshParams& params)
    : vertexArray_(gl::makeVertexArray()),
      // Measured along the depth camera's axis; the colour camera may see it somewhat nearer.
      nearestZ_(static_cast<float>(params.nearestM / 10)) {}

void LayerDrawer::draw(const MeshLayers& layers, const gl::Texture& color, glm::ivec4 tiles,
                       int instances) {
    glBindTextureUnit(2, color.name());
    drawLayer(layers.scene, tiles, {0.0F, 0.5F}, instances);
    glBindTextureUnit(2, layers.backgroundColor->name());
    drawLayer(layers.background, tiles, {0.5F, 0.5F}, instances);
}

void LayerDrawer::drawScene(const MeshLayer& scene) {
    drawLayer(scene, {1, 1, 0, 0}, {0.0F, 1.0F}, 1);
}

void LayerDrawer::drawPart(const MeshLayer& scene, const gl::Buffer& indices,
                           const gl::Buffer& command) {
    bindLayer(scene, {1, 1, 0, 0}, {0.0F, 1.0F});
    glVertexArrayElementBuffer(vertexArray_.name(), indices.name());
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, command.name());
    glDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, nullptr);
    glDisable(GL_DEPTH_TEST);
}

void LayerDrawer::target(GLuint framebuffer) const {
    bindTarget(framebuffer);
    glBindVertexArray(vertexArray_.name());
}

void LayerDrawer::clear(GLuint framebuffer, const std::array<double, 3>& color) {
    const std::array<float, 4> rgba{static_cast<float>(color[0]), static_cast<float>(color[1]),
                                    static_cast<float>(color[2]), 1.0F};
    const float farthest = 1.0F;
    bindTarget(framebuffer);
    glClearNamedFramebufferfv(framebuffer, GL_COLOR, 0, rgba.data());
    glClearNamedFramebufferfv(framebuffer, GL_DEPTH, 0, &farthest);
}

void LayerDrawer::bindLayer(const MeshLayer& layer, glm::ivec4 tiles, glm::vec2 depthRange) {
    tiles.w = layer.points.width();
    uniforms_.bind(1, {tiles, {nearestZ_, depthRange.x, depthRange.y, 0}});
    glBindTextureUnit(0, layer.points.name());
    glBindTextureUnit(1, layer.sources.name());
    glVertexArrayElementBuffer(vertexArray_.name(), layer.indices.name());
    glBindVertexArray(vertexArray_.name());
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
}

void LayerDrawer::drawLayer(const MeshLayer& layer, glm::ivec4 tiles, glm::vec2 depthRange,
                            int instances) {
    bindLayer(layer, tiles, depthRange);
    glDrawElementsInstanced(GL_TRIANGLES, layer.indexCount, GL_UNSIGNED_INT, nullptr, instances);
    glDisable(GL_DEPTH_TEST);
}

} // namespace autostereo::gpu
