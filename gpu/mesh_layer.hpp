#pragma once

#include "gpu/gl/objects.hpp"

namespace autostereo::gpu {

/// A grid of triangles with everything that no view changes, ready to be drawn by any of them.
struct MeshLayer {
    gl::Texture points;  ///< RGBA32F per node: u, v, disparity at |b| = 1, z (m; 0: no node)
    gl::Texture sources; ///< RG32F per node: where the colour image sees it
    gl::Buffer indices;  ///< 6 per cell; cut triangles are degenerate
    GLsizei indexCount = 0;
};

/// The scene as measured, and what lies behind it where it was cut or has holes.
struct MeshLayers {
    MeshLayer scene;
    MeshLayer background;
};

} // namespace autostereo::gpu
