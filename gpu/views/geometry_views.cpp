#include "gpu/views/geometry_views.hpp"

#include "gpu/views/view_synthesis.hpp"

#include <algorithm>
#include <string>

namespace autostereo::gpu {

namespace {

constexpr int kComponents = 4 + 4 + 2; // position, clip distances, texture coordinate

} // namespace

int GeometryViews::allowed(int wanted, int views, int componentsPerVertex) {
    GLint vertices = 0, components = 0;
    glGetIntegerv(GL_MAX_GEOMETRY_OUTPUT_VERTICES, &vertices);
    glGetIntegerv(GL_MAX_GEOMETRY_TOTAL_OUTPUT_COMPONENTS, &components);
    const int most = std::max(1, std::min(vertices, components / componentsPerVertex) / 3);
    return std::min(views, wanted > 0 ? std::min(wanted, most) : most);
}

GeometryViews::GeometryViews(const calib::DisplayProfile& display, const PipelineParams& params,
                             int viewsPerPass)
    : params_(params), viewsPerPass_(allowed(viewsPerPass, display.views, kComponents)),
      drawer_(params.mesh), program_({"mesh_view.vert", "mesh_views.geom", "mesh_view.frag"},
                                     {"REPEATED", "VIEWS " + std::to_string(viewsPerPass_)}),
      positions_(makeViewPositions(display)) {}

void GeometryViews::render(const MeshLayers& layers, const gl::Texture& color, const Atlas& atlas) {
    const AtlasLayout& layout = atlas.layout();
    LayerDrawer::clear(atlas.framebuffer(), params_.clearColor);
    glViewport(0, 0, layout.width(), layout.height());
    program_.use();
    glBindTextureUnit(3, positions_.name());
    const ClippedToTiles clipped;
    for (int first = 0; first < layout.views; first += viewsPerPass_)
        drawer_.draw(layers, color, {layout.quilt.columns, layout.quilt.rows, first, 0}, 1);
}

} // namespace autostereo::gpu
