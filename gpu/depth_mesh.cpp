#include "gpu/depth_mesh.hpp"

#include "gpu/gl/dispatch.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace autostereo::gpu {

namespace {

constexpr float kNoRay = 1e30F; // shaders/mesh_block.glsl tests for less

gl::Texture makeRays(const calib::CameraModel& camera) {
    const int width = camera.intrinsics.width, height = camera.intrinsics.height;
    std::vector<glm::vec2> rays;
    rays.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            rays.emplace_back(camera.unproject({x, y}).value_or(glm::dvec2(kNoRay)));
    gl::Texture texture(GL_RG32F, width, height);
    glTextureSubImage2D(texture.name(), 0, 0, 0, width, height, GL_RG, GL_FLOAT, rays.data());
    return texture;
}

} // namespace

DepthMesh::DepthMesh(const DepthMeshParams& params, const calib::SensorRig& rig)
    : params_(params), rig_(rig), points_({"mesh_points.comp"}), indices_({"mesh_indices.comp"}) {}

void DepthMesh::build(const gl::Texture& depth, double depthUnitM, const SceneGeometry& geometry) {
    if (!layer_.points.isSized(depth.width(), depth.height()))
        resize(depth.width(), depth.height());
    setBlock(depthUnitM, geometry);
    uniforms_.bind(0, block_);
    buildPoints(depth);
    buildIndices(depth);
}

void DepthMesh::resize(int width, int height) {
    rays_ = makeRays(rig_.depth.resized(width, height));
    layer_ = makeMeshLayer(width, height, std::max(0, width - 1) * std::max(0, height - 1));
}

void DepthMesh::setBlock(double depthUnitM, const SceneGeometry& geometry) {
    const auto& [framing, law, grid] = geometry;
    const calib::Intrinsics& pinhole = rig_.color.intrinsics;
    const calib::Distortion& bend = rig_.color.distortion;
    const CountRange range = countRange(params_, depthUnitM);
    glm::dmat4 pose(rig_.colorFromDepth.rotation);
    pose[3] = glm::dvec4(rig_.colorFromDepth.translation, 1);
    block_.colorFromDepth = pose;
    block_.colorPinhole = glm::dvec4(pinhole.fx, pinhole.fy, pinhole.cx, pinhole.cy);
    // Squared, it must stay finite in float.
    const double radius = std::min(bend.metricRadius, 1e9);
    block_.colorSize = glm::dvec4(pinhole.width, pinhole.height, radius * radius, 0);
    block_.colorRadial = glm::dvec4(bend.k1, bend.k2, bend.k3, bend.p1);
    block_.colorRational = glm::dvec4(bend.k4, bend.k5, bend.k6, bend.p2);
    block_.framing = glm::dvec4(framing.left, framing.bottom, framing.width, framing.height);
    block_.grid = glm::dvec4(grid.columns, grid.rows, grid.marginU, grid.marginV);
    block_.law = glm::dvec4(law.focusM, law.scale, law.viewerDistanceM, law.fanHalfWidth);
    block_.budget = glm::dvec4(law.farthest, law.nearest, depthUnitM, 0);
    block_.counts = glm::uvec4(range.nearest, range.farthest,
                               static_cast<unsigned>(std::lround(params_.cutRatio * 1000)), 0);
}

void DepthMesh::buildPoints(const gl::Texture& depth) {
    glBindTextureUnit(0, rays_.name());
    glBindTextureUnit(1, depth.name());
    glBindImageTexture(0, layer_.points.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
    glBindImageTexture(1, layer_.sources.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RG32F);
    gl::dispatch(points_, depth.width(), depth.height());
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
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
