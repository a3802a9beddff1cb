#include "gpu/views/multipass_views.hpp"

#include "gpu/views/view_synthesis.hpp"

namespace autostereo::gpu {

MultipassViews::MultipassViews(const calib::DisplayProfile& display, const PipelineParams& params)
    : params_(params), drawer_(params.mesh), program_({"mesh_view.vert", "mesh_view.frag"}),
      positions_(makeViewPositions(display)) {}

void MultipassViews::render(const MeshLayers& layers, const gl::Texture& color,
                            const Atlas& atlas) {
    const AtlasLayout& layout = atlas.layout();
    LayerDrawer::clear(atlas.framebuffer(), params_.clearColor);
    program_.use();
    glBindTextureUnit(3, positions_.name());
    for (int view = 0; view < layout.views; ++view) {
        glViewport(layout.left(view), layout.bottom(view), layout.quilt.tileWidth,
                   layout.quilt.tileHeight);
        drawer_.draw(layers, color, {1, 1, view, 0}, 1);
    }
}

} // namespace autostereo::gpu
