#include "gpu/fusion/fusion.hpp"

#include <cmath>

namespace autostereo::gpu {

FillBlock fillBlock(const FusionParams& params, const calib::SensorRig& rig,
                    const SceneGeometry& geometry) {
    constexpr double kUnsurePx = 1.5;     // depth pixels beside an edge whose colours may be mixed
    constexpr double kClearlyFiner = 1.3; // pixels per angle: then the colours' edges are better
    const bool colorIsFiner = rig.color.intrinsics.fx > kClearlyFiner * rig.depth.intrinsics.fx;
    const auto& [framing, law, grid, cutM] = geometry;
    const calib::Intrinsics& camera = rig.depth.intrinsics;
    const double pixelsAcross = framing.width * (framing.isSideways() ? camera.fy : camera.fx);
    const double texelsPerPixel = grid.columns / ((1 + 2 * grid.marginU) * pixelsAcross);
    const auto texels = [&](double px) { return static_cast<int>(std::ceil(px * texelsPerPixel)); };
    return {{params.fillReach, texels(params.edgeReachPx), texels(kUnsurePx),
             colorIsFiner ? texels(params.edgeBandPx) : 0}};
}

Fusion::Fusion(const PipelineParams& params, const calib::SensorRig& rig)
    : params_(params.fusion), rig_(rig), drawer_(params.mesh),
      cyclopean_({"mesh_cyclopean.vert", "mesh_depth.frag"}),
      cleared_({"cleared_blocks.vert", "cleared_blocks.frag"}), background_(params.backdrop) {}

void Fusion::fuse(const MeshLayer& measured, const gl::Texture& picture,
                  const SceneGeometry& geometry, const FusionChanges* changes) {
    const glm::ivec2 size{picture.width(), picture.height()};
    findChanges(geometry, size == pictureSize_ ? changes : nullptr);
    pictureSize_ = size;
    if (everything_)
        drawCyclopean(measured);
    else
        drawAgain(measured, changes->mesh);
    const BlockMarks& redrawn = everything_ ? nowhere_ : changes->mesh.footprint();
    const HoleFiller::Input color{picture, pictureMarks_.marks()};
    const FillBlock fill = fillBlock(params_, rig_, geometry);
    holes_.fill({depth_, redrawn}, color, fill, changes_.depth, lister_, everything_);
    if (params_.remember)
        background_.memory().remember(holes_.sureDepth(), holes_.sureChanged(), picture,
                                      pictureMarks_.marks(), lister_, everything_);
    background_.build(holes_, color, fill.reach.z, changes_, lister_, everything_);
}

void Fusion::findChanges(const SceneGeometry& geometry, const FusionChanges* changes) {
    const calib::CyclopeanGrid& grid = geometry.grid;
    if (!depth_.isSized(grid.columns, grid.rows)) resize(grid.columns, grid.rows);
    if (!geometry_ || !(geometry_->framing == geometry.framing)) background_.memory().forget();
    everything_ = changes == nullptr || !geometry_ || !(*geometry_ == geometry);
    geometry_ = geometry;
    changes_.depth.clear();
    changes_.color.clear();
    pictureMarks_.clear();
    if (everything_)
        pictureMarks_.place();
    else if (changes->picture != nullptr)
        pictureMarks_.mark(*changes->picture, changes_.color);
}

void Fusion::resize(int columns, int rows) {
    depth_ = gl::Texture(GL_R32F, columns, rows);
    depthTest_ = gl::Texture(GL_DEPTH_COMPONENT32F, columns, rows);
    framebuffer_ = gl::makeFramebuffer(depth_, &depthTest_);
    for (BlockMarks* marks : {&nowhere_, &changes_.depth, &changes_.color})
        marks->resize(columns, rows);
    pictureMarks_.resize(columns, rows);
    redrawn_.resize(columns, rows);
    holes_.resize(columns, rows);
    background_.resize(columns, rows);
}

void Fusion::drawCyclopean(const MeshLayer& measured) {
    LayerDrawer::clear(framebuffer_.name(), {0, 0, 0});
    glViewport(0, 0, depth_.width(), depth_.height());
    cyclopean_.use();
    drawer_.drawScene(measured);
}

/// Into cleared blocks, every triangle that reaches into one. Where it reaches out of them it meets
/// itself: what is as near as what is there draws nothing.
void Fusion::drawAgain(const MeshLayer& measured, const MeshRedraw& redraw) {
    lister_.list(redrawn_, {{redraw.footprint()}});
    drawer_.target(framebuffer_.name());
    glViewport(0, 0, depth_.width(), depth_.height());
    glEnable(GL_PROGRAM_POINT_SIZE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    cleared_.use();
    redrawn_.drawPoints();
    glDisable(GL_PROGRAM_POINT_SIZE);
    cyclopean_.use();
    drawer_.drawPart(measured, redraw.indices(), redraw.command());
}

} // namespace autostereo::gpu
