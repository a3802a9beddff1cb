#include "gpu/depth_mesh.hpp"

#include "gpu/mesh_nodes.hpp"

#include <algorithm>

namespace autostereo::gpu {

DepthMesh::DepthMesh(const DepthMeshParams& params, const calib::SensorRig& rig)
    : params_(params), rig_(rig), points_({"mesh_points.comp"}), indices_({"mesh_indices.comp"}) {}

void DepthMesh::build(const gl::Texture& depth, double depthUnitM, const SceneGeometry& geometry,
                      const BlockMarks* changed) {
    bool everything = changed == nullptr || isElsewhere(depthUnitM, geometry);
    if (!layer_.points.isSized(depth.width(), depth.height())) {
        resize(depth.width(), depth.height());
        everything = true;
    }
    everything |= redraw_.fitGrid(geometry.grid.columns, geometry.grid.rows);
    setBlock(depthUnitM, geometry);
    uniforms_.bind(0, block_);
    if (everything)
        list_.listAll();
    else
        lister_.list(list_, {{*changed, 1, 1}}); // with all corners of what has one that changed
    buildNodes(points_, layer_, rays_, depth, list_);
    if (everything)
        redraw_.markAll();
    else
        redraw_.mark(layer_, list_);
    buildIndices(depth);
    redraw_.pick(layer_, everything ? nullptr : changed);
}

bool DepthMesh::isElsewhere(double depthUnitM, const SceneGeometry& geometry) {
    const bool same = geometry_ && *geometry_ == geometry && depthUnitM_ == depthUnitM;
    geometry_ = geometry;
    depthUnitM_ = depthUnitM;
    return !same;
}

void DepthMesh::resize(int width, int height) {
    rays_ = makeRays(rig_.depth.resized(width, height));
    list_.resize(width, height);
    const bool hasCells = width > 1 && height > 1;
    const int blocks = hasCells ? list_.across() * list_.down() : 0;
    layer_ = makeMeshLayer(width, height, MeshLayer::kBlockCells * blocks);
    redraw_.resize(width, height);
}

void DepthMesh::setBlock(double depthUnitM, const SceneGeometry& geometry) {
    const auto& [framing, law, grid, cutM] = geometry;
    setCameras(block_, rig_, params_, depthUnitM);
    block_.framing = glm::dvec4(framing.left, framing.bottom, framing.width, framing.height);
    const glm::dmat2& upright = framing.uprightFromCamera;
    block_.upright = glm::dvec4(upright[0], upright[1]);
    block_.grid = glm::dvec4(grid.columns, grid.rows, grid.marginU, grid.marginV);
    block_.law = glm::dvec4(law.focusM, law.scale, law.viewerDistanceM, law.fanHalfWidth);
    block_.budget.x = static_cast<float>(law.farthest);
    block_.budget.y = static_cast<float>(law.nearest);
    block_.budget.w = static_cast<float>(cutM);
}

void DepthMesh::buildIndices(const gl::Texture& depth) {
    if (layer_.indexCount == 0) return; // a single row or column spans no cell
    glBindTextureUnit(0, layer_.points.name());
    glBindTextureUnit(1, depth.name());
    glBindImageTexture(0, redraw_.before().name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, layer_.indices.name());
    list_.dispatch(indices_);
    glMemoryBarrier(GL_ELEMENT_ARRAY_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
}

} // namespace autostereo::gpu
