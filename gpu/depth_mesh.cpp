#include "gpu/depth_mesh.hpp"

#include "gpu/gl/dispatch.hpp"
#include "gpu/mesh_nodes.hpp"

#include <algorithm>

namespace autostereo::gpu {

DepthMesh::DepthMesh(const DepthMeshParams& params, const calib::SensorRig& rig)
    : params_(params), rig_(rig), points_({"mesh_points.comp"}), indices_({"mesh_indices.comp"}) {}

void DepthMesh::build(const gl::Texture& depth, double depthUnitM, const SceneGeometry& geometry) {
    if (!layer_.points.isSized(depth.width(), depth.height()))
        resize(depth.width(), depth.height());
    setBlock(depthUnitM, geometry);
    uniforms_.bind(0, block_);
    buildNodes(points_, layer_, rays_, depth);
    buildIndices(depth);
}

void DepthMesh::resize(int width, int height) {
    rays_ = makeRays(rig_.depth.resized(width, height));
    layer_ = makeMeshLayer(width, height, std::max(0, width - 1) * std::max(0, height - 1));
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
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, layer_.indices.name());
    gl::dispatch(indices_, depth.width() - 1, depth.height() - 1);
    glMemoryBarrier(GL_ELEMENT_ARRAY_BARRIER_BIT);
}

} // namespace autostereo::gpu
