#include "gpu/depth_mesh.hpp"

#include "gpu/gl/dispatch.hpp"
#include "gpu/mesh_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace autostereo::gpu {

namespace {

std::vector<std::string> backgroundDefine() {
    return {"BACKGROUND " + std::to_string(DepthMesh::kBackgroundStride)};
}

MeshLayer makeLayer(int width, int height) {
    const int cells = std::max(0, width - 1) * std::max(0, height - 1);
    MeshLayer layer;
    layer.points = gl::Texture(GL_RGBA32F, width, height);
    layer.sources = gl::Texture(GL_RG32F, width, height);
    layer.indexCount = 6 * cells;
    layer.indices = gl::makeBuffer(
        sizeof(GLuint) * static_cast<std::size_t>(std::max(1, layer.indexCount)), nullptr, 0);
    return layer;
}

} // namespace

DepthMesh::DepthMesh(const DepthMeshParams& params, const calib::SensorRig& rig)
    : params_(params), rig_(rig), reduce_({"background_reduce.comp"}, backgroundDefine()),
      spread_({"background_spread.comp"}, backgroundDefine()), scenePoints_({"mesh_points.comp"}),
      sceneIndices_({"mesh_indices.comp"}),
      backgroundPoints_({"mesh_points.comp"}, backgroundDefine()),
      backgroundIndices_({"mesh_indices.comp"}, backgroundDefine()) {}

void DepthMesh::build(const gl::Texture& depth, double depthUnitM, const SceneGeometry& geometry) {
    const auto& [scene, background] = layers_;
    if (!scene.points.isSized(depth.width(), depth.height())) resize(depth.width(), depth.height());
    setBlock(depthUnitM, geometry);
    uniforms_.bind(0, block_);
    buildNodes(scenePoints_, scene, rays_, depth);
    visibility_.hide(scene, depth);
    buildIndices(scene, depth, sceneIndices_);
    buildSamples(depth);
    buildNodes(backgroundPoints_, background, rays_, samples_);
    buildIndices(background, samples_, backgroundIndices_);
}

void DepthMesh::resize(int width, int height) {
    constexpr int kStride = kBackgroundStride;
    const int columns = (width + kStride - 2) / kStride + 1;
    const int rows = (height + kStride - 2) / kStride + 1;
    rays_ = makeRays(rig_.depth.resized(width, height));
    reduced_ = gl::Texture(GL_RGBA16UI, columns, rows);
    samples_ = gl::Texture(GL_RGBA16UI, columns, rows);
    layers_ = {makeLayer(width, height), makeLayer(columns, rows)};
}

void DepthMesh::setBlock(double depthUnitM, const SceneGeometry& geometry) {
    const auto& [framing, law] = geometry;
    setCameras(block_, rig_, params_, depthUnitM);
    block_.framing = glm::dvec4(framing.left, framing.bottom, framing.width, framing.height);
    block_.law = glm::dvec4(law.focusM, law.scale, law.viewerDistanceM, law.fanHalfWidth);
    block_.budget.x = static_cast<float>(law.farthest);
    block_.budget.y = static_cast<float>(law.nearest);

    // The widest gap that a view can open, in background nodes: the whole budget, in panel widths,
    // over what one node covers of the panel.
    const double pixelsPerPanel = framing.width * rig_.depth.intrinsics.fx *
                                  layers_.scene.points.width() / rig_.depth.intrinsics.width;
    const double reach =
        std::ceil((law.nearest - law.farthest) * pixelsPerPanel / kBackgroundStride) + 1;
    constexpr double kLongestReach = 256; // bounds the shader's loop whatever the numbers say
    block_.counts.w = static_cast<unsigned>(std::clamp(reach, 1.0, kLongestReach));
}

void DepthMesh::buildSamples(const gl::Texture& depth) {
    const int columns = samples_.width(), rows = samples_.height();
    glBindTextureUnit(0, visibility_.clean().name());
    glBindTextureUnit(1, depth.name());
    glBindImageTexture(0, reduced_.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA16UI);
    gl::dispatch(reduce_, columns, rows);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    glBindTextureUnit(0, reduced_.name());
    glBindImageTexture(0, samples_.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA16UI);
    gl::dispatch(spread_, columns, rows);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

void DepthMesh::buildIndices(const MeshLayer& layer, const gl::Texture& nodes,
                             const gl::Program& indices) {
    if (layer.indexCount == 0) return; // a single row or column spans no cell
    glBindTextureUnit(0, layer.points.name());
    glBindTextureUnit(1, nodes.name());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, layer.indices.name());
    gl::dispatch(indices, layer.points.width() - 1, layer.points.height() - 1);
    glMemoryBarrier(GL_ELEMENT_ARRAY_BARRIER_BIT);
}

} // namespace autostereo::gpu
