#include "gpu/scene/scene_pipeline.hpp"

#include "calib/panel_map.hpp"
#include "gpu/layer_drawer.hpp"
#include "gpu/views/view_synthesis.hpp"

#include <algorithm>

namespace autostereo::gpu {

namespace {

AtlasLayout layoutOf(const calib::DisplayProfile& display, const PipelineParams& params, int width,
                     int height) {
    return scaled(atlasLayout(display, width, height), params.synthesis.tileScale);
}

/// Sub-pixels see between tiles' texels: twice as many each way, but no more than the panel has.
calib::QuiltLayout searchedTexels(calib::QuiltLayout tile, int panelWidth, int panelHeight) {
    tile.tileWidth = std::min(2 * tile.tileWidth, std::max(tile.tileWidth, panelWidth));
    tile.tileHeight = std::min(2 * tile.tileHeight, std::max(tile.tileHeight, panelHeight));
    return tile;
}

} // namespace

ScenePipeline::Disparity::Disparity(int width, int height)
    : program({"scene_view.vert", "scene_view.frag"}, {"DISPARITY"}),
      texture(GL_R32F, width, height), depth(GL_DEPTH_COMPONENT32F, width, height),
      framebuffer(gl::makeFramebuffer(texture, &depth)) {}

Method sceneMethod(Method wanted, SceneShading shading, const calib::DisplayProfile& display,
                   std::size_t triangles) {
    constexpr double kWorthSearching = 1.5e6;
    if (wanted == Method::Auto)
        wanted = static_cast<double>(triangles) * display.views < kWorthSearching
                     ? Method::Instanced
                     : Method::Direct;
    const bool isDeferred = wanted == Method::Hybrid || wanted == Method::Direct;
    const bool makesViews = std::holds_alternative<calib::DepthFrame>(display.law);
    if ((isDeferred && shading == SceneShading::PerVertex) ||
        (wanted == Method::Direct && makesViews))
        return Method::Instanced;
    return wanted;
}

ScenePipeline::ScenePipeline(const devices::mesh::MeshScene& scene, const SceneParams& look,
                             const PipelineParams& params, const calib::DisplayProfile& display,
                             int panelWidth, int panelHeight)
    : scene_(scene), look_(look), params_(params), display_(display),
      placement_(scenePlacement(extent(scene, uprightTurn(look.up)), look, display,
                                static_cast<double>(panelWidth) / panelHeight)),
      block_(sceneBlock(look, placement_, display, static_cast<double>(panelWidth) / panelHeight)),
      model_(scene),
      method_(sceneMethod(params.synthesis.method, look.shading, display, scene.triangles())) {
    makeMethod(panelWidth, panelHeight);
    if (!std::holds_alternative<calib::DepthFrame>(display.law)) return;
    const calib::QuiltLayout& tiles = atlas_->layout().quilt;
    disparity_.emplace(tiles.tileWidth, tiles.tileHeight);
    disparity_->eye = makeEyes({{0, 0, display.viewingDistanceM}});
}

void ScenePipeline::makeMethod(int panelWidth, int panelHeight) {
    const AtlasLayout layout = layoutOf(display_, params_, panelWidth, panelHeight);
    const calib::PanelMap map = calib::panelMap(display_, panelWidth, panelHeight);
    InterleaverParams shown{params_.synthesis.filter, params_.synthesis.views, display_.fringe, {}};
    if (method_ == Method::Hybrid || method_ == Method::Direct)
        surfaces_.emplace(display_, placement_, look_.shading,
                          method_ == Method::Direct
                              ? searchedTexels(layout.quilt, panelWidth, panelHeight)
                              : layout.quilt,
                          params_.synthesis.references, params_.clearColor);
    else
        views_.emplace(display_, look_, params_.synthesis, params_.clearColor);
    if (method_ == Method::Direct) {
        shown.views = ViewFilter::Nearest;
        shown.search = prepareSearch(map, panelWidth, panelHeight);
    } else {
        atlas_.emplace(layout);
    }
    if (method_ == Method::Hybrid) reprojection_.emplace(display_, look_.shading);
    interleaver_ = makeInterleaver(map, panelWidth, panelHeight, shown);
}

SearchParams ScenePipeline::prepareSearch(const calib::PanelMap& map, int width, int height) {
    positions_ = makeViewPositions(display_);
    SearchParams search = searchParams(display_, map, params_.synthesis.positions);
    search.scene = look_.shading;
    // Before black a sub-pixel without anything is black, whatever else it may be.
    const auto* views = std::get_if<calib::ViewMap>(&map);
    search.tilesOnly = views != nullptr && params_.clearColor == std::array<double, 3>{};
    if (search.tilesOnly) tiles_.emplace(width, height, search, views->upsideDown);
    return search;
}

void ScenePipeline::prepare(double seconds) {
    model_.place(scene_, seconds, placement_.transform(look_, seconds));
    if (surfaces_) surfaces_->draw(model_, block_);
    if (reprojection_) reprojection_->render(*surfaces_, model_, block_, *atlas_);
    if (views_) views_->render(model_, block_, *atlas_);
    if (disparity_) drawDisparity();
}

void ScenePipeline::drawDisparity() {
    const auto background = static_cast<double>(display_.disparityFar);
    LayerDrawer::clear(disparity_->framebuffer.name(), {background, 0, 0});
    glViewport(0, 0, disparity_->texture.width(), disparity_->texture.height());
    glBindTextureUnit(2, disparity_->eye.name());
    uniforms_.bind(7, block_);
    disparity_->program.use();
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    model_.draw(1);
    glDisable(GL_DEPTH_TEST);
}

void ScenePipeline::bindSearch(GLuint panel) {
    surfaces_->bind();
    uniforms_.bind(7, block_);
    glBindTextureUnit(10, positions_.name());
    glBindTextureUnit(11, model_.parts().name());
    if (!tiles_) return;
    LayerDrawer::clear(panel, params_.clearColor);
    tiles_->list();
}

void ScenePipeline::show(GLuint panel) {
    if (method_ == Method::Direct) bindSearch(panel);
    interleaver_->render({atlas_ ? &*atlas_ : nullptr, disparity_ ? &disparity_->texture : nullptr},
                         panel);
}

RgbImage ScenePipeline::renderEye(const glm::dvec3& eye, int width, int height) {
    const gl::Program program({"scene_view.vert", "scene_view.frag"}, definesOf(look_.shading));
    const gl::Texture eyes = makeEyes({eye});
    const gl::Texture color(GL_RGBA8, width, height);
    const gl::Texture depth(GL_DEPTH_COMPONENT32F, width, height);
    const gl::Framebuffer target = gl::makeFramebuffer(color, &depth);
    LayerDrawer::clear(target.name(), params_.clearColor);
    glViewport(0, 0, width, height);
    glBindTextureUnit(2, eyes.name());
    uniforms_.bind(7, block_);
    program.use();
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    model_.draw(1);
    glDisable(GL_DEPTH_TEST);
    return readFramebuffer(target.name(), width, height);
}

} // namespace autostereo::gpu
