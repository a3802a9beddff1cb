#include "gpu/scene/scene_views.hpp"

#include "calib/view_map.hpp"
#include "gpu/layer_drawer.hpp"
#include "gpu/views/atlas_views.hpp"
#include "gpu/views/geometry_views.hpp"

#include <cmath>
#include <string>

namespace autostereo::gpu {

namespace {

constexpr int kComponents = 4 + 4 + 2 + 2 + 3 + 3; // position, clip distances, what corners hand on

Method drawnBy(Method wanted) {
    switch (wanted) {
    case Method::Multipass:
    case Method::Geometry:
    case Method::Layered:
        return wanted;
    default:
        return Method::Instanced;
    }
}

gl::Program makeProgram(Method method, SceneShading shading, int viewsPerPass) {
    std::vector<std::string> defines = definesOf(shading);
    if (method == Method::Instanced) defines.emplace_back("TILED");
    if (method == Method::Layered) defines.emplace_back("LAYERED");
    if (method != Method::Geometry && method != Method::Layered)
        return gl::Program({"scene_view.vert", "scene_view.frag"}, defines);
    defines.emplace_back("REPEATED");
    defines.push_back("VIEWS " + std::to_string(viewsPerPass));
    return gl::Program({"scene_view.vert", "scene_view.geom", "scene_view.frag"}, defines);
}

} // namespace

std::vector<std::string> definesOf(SceneShading shading) {
    switch (shading) {
    case SceneShading::None:
        return {"PLAIN"};
    case SceneShading::PerVertex:
        return {"PER_VERTEX"};
    case SceneShading::PerPixel:
        return {"PER_PIXEL"};
    case SceneShading::Textured:
        break;
    }
    return {};
}

gl::Texture makeEyes(const std::vector<glm::dvec3>& eyes) {
    std::vector<glm::vec4> texels;
    texels.reserve(eyes.size());
    for (const glm::dvec3& eye : eyes)
        texels.emplace_back(glm::dvec4(eye, 0));
    gl::Texture texture(GL_RGBA32F, static_cast<int>(eyes.size()), 1);
    glTextureSubImage2D(texture.name(), 0, 0, 0, texture.width(), 1, GL_RGBA, GL_FLOAT,
                        texels.data());
    return texture;
}

glm::dvec3 fanEye(const calib::DisplayProfile& display, double b) {
    return {b * display.viewingDistanceM * std::tan(display.coneRad / 2), 0,
            display.viewingDistanceM};
}

std::vector<glm::dvec3> viewEyes(const calib::DisplayProfile& display) {
    std::vector<glm::dvec3> eyes;
    for (int view = 0; view < display.views; ++view)
        eyes.push_back(fanEye(display, calib::viewPosition(display, view)));
    return eyes;
}

SceneViews::SceneViews(const calib::DisplayProfile& display, const SceneParams& scene,
                       const SynthesisParams& synthesis, const std::array<double, 3>& clearColor)
    : method_(drawnBy(synthesis.method)), clearColor_(clearColor),
      viewsPerPass_(GeometryViews::allowed(synthesis.viewsPerPass, display.views, kComponents)),
      program_(makeProgram(method_, scene.shading, viewsPerPass_)),
      eyes_(makeEyes(viewEyes(display))) {}

void SceneViews::render(const SceneModel& model, const SceneBlock& block, const Atlas& atlas) {
    const AtlasLayout& layout = atlas.layout();
    SceneBlock own = block;
    own.viewTiles = {layout.quilt.columns, layout.quilt.rows, 0, layout.views};
    glBindTextureUnit(2, eyes_.name());
    if (method_ == Method::Layered) return layered(model, own, atlas);
    LayerDrawer::clear(atlas.framebuffer(), clearColor_);
    glViewport(0, 0, layout.width(), layout.height());
    program_.use();
    const DepthTest depthTest;
    if (method_ == Method::Multipass) return eachView(model, own, layout);
    const ClippedToTiles clipped;
    if (method_ == Method::Geometry) return repeated(model, own);
    uniforms_.bind(7, own);
    model.draw(layout.views);
}

void SceneViews::eachView(const SceneModel& model, SceneBlock block, const AtlasLayout& layout) {
    for (int view = 0; view < layout.views; ++view) {
        glViewport(layout.left(view), layout.bottom(view), layout.quilt.tileWidth,
                   layout.quilt.tileHeight);
        block.viewTiles.z = view;
        uniforms_.bind(7, block);
        model.draw(1);
    }
}

void SceneViews::repeated(const SceneModel& model, SceneBlock block) {
    for (int first = 0; first < block.viewTiles.w; first += viewsPerPass_) {
        block.viewTiles.z = first;
        uniforms_.bind(7, block);
        model.draw(1);
    }
}

void SceneViews::layered(const SceneModel& model, const SceneBlock& block, const Atlas& atlas) {
    const AtlasLayout& layout = atlas.layout();
    const auto& [tilesX, tilesY, width, height] = layout.quilt;
    if (!colors_.isSized(width, height)) {
        colors_ = gl::Texture(GL_RGBA8, width, height, layout.views);
        depths_ = gl::Texture(GL_DEPTH_COMPONENT32F, width, height, layout.views);
        framebuffer_ = gl::makeFramebuffer(colors_, &depths_);
    }
    LayerDrawer::clear(framebuffer_.name(), clearColor_);
    glViewport(0, 0, width, height);
    program_.use();
    {
        const DepthTest depthTest;
        repeated(model, block);
    }
    for (int view = 0; view < layout.views; ++view)
        glCopyImageSubData(colors_.name(), GL_TEXTURE_2D_ARRAY, 0, 0, 0, view, atlas.color().name(),
                           GL_TEXTURE_2D, 0, layout.left(view), layout.bottom(view), 0, width,
                           height, 1);
}

} // namespace autostereo::gpu
