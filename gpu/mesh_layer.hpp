#pragma once

#include "gpu/gl/objects.hpp"

namespace autostereo::gpu {

/// A grid of vertices with everything that no view changes, ready to be drawn by any of them.
struct MeshLayer {
    static constexpr int kBlockCells = 64; ///< of the depth grid's: 8 x 8 after another
    gl::Texture points;  ///< RGBA32F per vertex: u, v, disparity at |b| = 1, z (m; 0: none)
    gl::Texture sources; ///< RG32F per vertex: texture coordinate of its colour
    gl::Buffer indices;  ///< 6 per cell; triangles that are not drawn are degenerate
    GLsizei indexCount = 0;
};

[[nodiscard]] inline MeshLayer makeMeshLayer(int columns, int rows, int cells) {
    MeshLayer layer;
    layer.points = gl::Texture(GL_RGBA32F, columns, rows);
    layer.sources = gl::Texture(GL_RG32F, columns, rows);
    layer.indexCount = 6 * cells;
    const int atLeastOne = cells > 0 ? layer.indexCount : 6;
    layer.indices =
        gl::makeBuffer(sizeof(GLuint) * static_cast<std::size_t>(atLeastOne), nullptr, 0);
    return layer;
}

/// The cyclopean scene, and what a view sees beside and behind it, in a picture of its own.
struct MeshLayers {
    MeshLayer scene;
    MeshLayer background;
    const gl::Texture* backgroundColor = nullptr; ///< RGBA8, its owner's
};

} // namespace autostereo::gpu
