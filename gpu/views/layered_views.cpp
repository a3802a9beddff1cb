#include "gpu/views/layered_views.hpp"

#include "gpu/views/geometry_views.hpp"
#include "gpu/views/view_synthesis.hpp"

#include <string>

namespace autostereo::gpu {

namespace {
constexpr int kComponents = 4 + 1 + 2; // position, layer, texture coordinate
}

LayeredViews::LayeredViews(const calib::DisplayProfile& display, const PipelineParams& params,
                           int viewsPerPass)
    : params_(params),
      viewsPerPass_(GeometryViews::allowed(viewsPerPass, display.views, kComponents)),
      drawer_(params.mesh),
      program_({"mesh_view.vert", "mesh_views.geom", "mesh_view.frag"},
               {"REPEATED", "LAYERED", "VIEWS " + std::to_string(viewsPerPass_)}),
      positions_(makeViewPositions(display)) {}

void LayeredViews::render(const MeshLayers& layers, const gl::Texture& color, const Atlas& atlas) {
    const AtlasLayout& layout = atlas.layout();
    const auto& [tilesX, tilesY, width, height] = layout.quilt;
    if (!colors_.isSized(width, height)) resize(layout);
    LayerDrawer::clear(framebuffer_.name(), params_.clearColor);
    glViewport(0, 0, width, height);
    program_.use();
    glBindTextureUnit(3, positions_.name());
    for (int first = 0; first < layout.views; first += viewsPerPass_)
        drawer_.draw(layers, color, {1, 1, first, 0}, 1);
    for (int view = 0; view < layout.views; ++view)
        glCopyImageSubData(colors_.name(), GL_TEXTURE_2D_ARRAY, 0, 0, 0, view, atlas.color().name(),
                           GL_TEXTURE_2D, 0, layout.left(view), layout.bottom(view), 0, width,
                           height, 1);
}

void LayeredViews::resize(const AtlasLayout& layout) {
    const auto& [tilesX, tilesY, width, height] = layout.quilt;
    colors_ = gl::Texture(GL_RGBA8, width, height, layout.views);
    depths_ = gl::Texture(GL_DEPTH_COMPONENT32F, width, height, layout.views);
    framebuffer_ = gl::makeFramebuffer(colors_, &depths_);
}

} // namespace autostereo::gpu
