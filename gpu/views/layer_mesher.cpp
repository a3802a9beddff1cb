#include "gpu/views/layer_mesher.hpp"

#include "gpu/gl/dispatch.hpp"

#include <vector>

namespace autostereo::gpu {

namespace {

/// Two triangles for each cell of a grid of nodes.
gl::Buffer gridIndices(int columns, int rows) {
    std::vector<GLuint> indices;
    const auto width = static_cast<GLuint>(columns);
    indices.reserve(6 * static_cast<std::size_t>(columns - 1) * static_cast<std::size_t>(rows - 1));
    for (GLuint y = 0; y + 1 < static_cast<GLuint>(rows); ++y)
        for (GLuint x = 0; x + 1 < width; ++x) {
            const GLuint here = y * width + x, below = here + width;
            indices.insert(indices.end(), {here, below, here + 1, here + 1, below, below + 1});
        }
    return gl::makeBuffer(indices.size() * sizeof(GLuint), indices.data(), 0);
}

void build(const gl::Program& program, const gl::Texture& depth, const MeshLayer& layer, int width,
           int height) {
    glBindTextureUnit(0, depth.name());
    glBindImageTexture(0, layer.points.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
    glBindImageTexture(1, layer.sources.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RG32F);
    gl::dispatch(program, width, height);
}

} // namespace

LayerMesher::LayerMesher() : quads_({"layer_quads.comp"}), nodes_({"layer_nodes.comp"}) {}

const MeshLayers& LayerMesher::build(const CyclopeanScene& scene) {
    const int columns = scene.depth.width(), rows = scene.depth.height();
    const auto& [front, background, unused] = layers_;
    if (!front.points.isSized(2 * columns, 2 * rows)) resize(columns, rows);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, front.indices.name());
    gpu::build(quads_, scene.depth, front, columns, rows);
    gpu::build(nodes_, scene.backgroundDepth, background, columns + 1, rows + 1);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_ELEMENT_ARRAY_BARRIER_BIT);
    layers_.backgroundColor = &scene.backgroundColor;
    return layers_;
}

void LayerMesher::resize(int columns, int rows) {
    layers_.scene = makeMeshLayer(2 * columns, 2 * rows, columns * rows);
    layers_.background = makeMeshLayer(columns + 1, rows + 1, columns * rows);
    layers_.background.indices = gridIndices(columns + 1, rows + 1);
}

} // namespace autostereo::gpu
