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
      cyclopean_({"mesh_cyclopean.vert", "mesh_depth.frag"}), background_(params.backdrop) {}

void Fusion::fuse(const MeshLayer& measured, const gl::Texture& picture,
                  const SceneGeometry& geometry) {
    const calib::CyclopeanGrid& grid = geometry.grid;
    if (!depth_.isSized(grid.columns, grid.rows)) resize(grid.columns, grid.rows);
    if (!(framing_ == geometry.framing)) background_.memory().forget();
    framing_ = geometry.framing;
    drawCyclopean(measured);
    holes_.fill(depth_, picture, fillBlock(params_, rig_, geometry));
    if (params_.remember) background_.memory().remember(holes_.sureDepth(), picture);
    background_.build(holes_.sureDepth(), holes_.depth(), picture);
}

void Fusion::resize(int columns, int rows) {
    depth_ = gl::Texture(GL_R32F, columns, rows);
    depthTest_ = gl::Texture(GL_DEPTH_COMPONENT32F, columns, rows);
    framebuffer_ = gl::makeFramebuffer(depth_, &depthTest_);
    holes_.resize(columns, rows);
    background_.resize(columns, rows);
}

void Fusion::drawCyclopean(const MeshLayer& measured) {
    LayerDrawer::clear(framebuffer_.name(), {0, 0, 0});
    glViewport(0, 0, depth_.width(), depth_.height());
    cyclopean_.use();
    drawer_.drawScene(measured);
}

} // namespace autostereo::gpu
