#include "gpu/fusion/fusion.hpp"

#include "gpu/gl/dispatch.hpp"

#include <cmath>
#include <vector>

namespace autostereo::gpu {

namespace {

/// Two triangles for each cell of a grid of nodes.
gl::Buffer gridIndices(int columns, int rows) {
    std::vector<GLuint> indices;
    const auto width = static_cast<GLuint>(columns);
    for (GLuint y = 0; y + 1 < static_cast<GLuint>(rows); ++y)
        for (GLuint x = 0; x + 1 < width; ++x) {
            const GLuint here = y * width + x, below = here + width;
            indices.insert(indices.end(), {here, below, here + 1, here + 1, below, below + 1});
        }
    return gl::makeBuffer(indices.size() * sizeof(GLuint), indices.data(), 0);
}

} // namespace

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
      cyclopean_({"mesh_cyclopean.vert", "mesh_depth.frag"}), quads_({"layer_quads.comp"}),
      nodes_({"layer_nodes.comp"}), background_(params.backdrop) {}

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
    buildLayers();
}

void Fusion::resize(int columns, int rows) {
    depth_ = gl::Texture(GL_R32F, columns, rows);
    depthTest_ = gl::Texture(GL_DEPTH_COMPONENT32F, columns, rows);
    framebuffer_ = gl::makeFramebuffer(depth_, &depthTest_);
    holes_.resize(columns, rows);
    background_.resize(columns, rows);
    layers_.scene = makeMeshLayer(2 * columns, 2 * rows, columns * rows);
    layers_.background = makeMeshLayer(columns, rows, (columns - 1) * (rows - 1));
    layers_.background.indices = gridIndices(columns, rows);
    layers_.backgroundColor = &background_.color();
}

void Fusion::drawCyclopean(const MeshLayer& measured) {
    LayerDrawer::clear(framebuffer_.name(), {0, 0, 0});
    glViewport(0, 0, depth_.width(), depth_.height());
    cyclopean_.use();
    drawer_.drawScene(measured);
}

void Fusion::buildLayers() {
    const auto& [scene, background, unused] = layers_;
    glBindTextureUnit(0, holes_.depth().name());
    glBindImageTexture(0, scene.points.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
    glBindImageTexture(1, scene.sources.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RG32F);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, scene.indices.name());
    gl::dispatch(quads_, depth_.width(), depth_.height());

    glBindTextureUnit(0, background_.depth().name());
    glBindImageTexture(0, background.points.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
    glBindImageTexture(1, background.sources.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RG32F);
    gl::dispatch(nodes_, depth_.width(), depth_.height());
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_ELEMENT_ARRAY_BARRIER_BIT);
}

} // namespace autostereo::gpu
