#include "gpu/views/disparity_view.hpp"

namespace autostereo::gpu {

DisparityView::DisparityView(const DepthMeshParams& params, int width, int height, double farthest)
    : drawer_(params), program_({"mesh_view.vert", "mesh_disparity.frag"}, {"DISPARITY"}),
      disparity_(GL_R32F, width, height), depth_(GL_DEPTH_COMPONENT32F, width, height),
      framebuffer_(gl::makeFramebuffer(disparity_, &depth_)), position_(GL_R32F, 1, 1),
      farthest_(farthest) {
    const float middle = 0;
    glTextureSubImage2D(position_.name(), 0, 0, 0, 1, 1, GL_RED, GL_FLOAT, &middle);
}

void DisparityView::render(const MeshLayers& layers, const gl::Texture& color) {
    LayerDrawer::clear(framebuffer_.name(), {farthest_, 0, 0});
    glViewport(0, 0, disparity_.width(), disparity_.height());
    program_.use();
    glBindTextureUnit(3, position_.name());
    drawer_.draw(layers, color, {1, 1, 0, 0}, 1);
}

} // namespace autostereo::gpu
