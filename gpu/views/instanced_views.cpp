#include "gpu/views/instanced_views.hpp"

#include "gpu/views/view_synthesis.hpp"

namespace autostereo::gpu {

InstancedViews::InstancedViews(const calib::DisplayProfile& display, const PipelineParams& params)
    : params_(params), drawer_(params.mesh),
      program_({"mesh_view.vert", "mesh_view.frag"}, {"TILED"}),
      positions_(makeViewPositions(display)) {}

void InstancedViews::render(const MeshLayers& layers, const gl::Texture& color,
                            const Atlas& atlas) {
    const AtlasLayout& layout = atlas.layout();
    LayerDrawer::clear(atlas.framebuffer(), params_.clearColor);
    glViewport(0, 0, layout.width(), layout.height());
    program_.use();
    glBindTextureUnit(3, positions_.name());
    const ClippedToTiles clipped;
    drawer_.draw(layers, color, {layout.quilt.columns, layout.quilt.rows, 0, 0}, layout.views);
}

} // namespace autostereo::gpu
