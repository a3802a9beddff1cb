#pragma once

#include "gpu/gl/objects.hpp"

namespace autostereo::gpu {

/// What the views are made from: one clean picture of the scene and of what stands behind it, on
/// the cyclopean grid. The textures are their owners'.
struct CyclopeanScene {
    const gl::Texture& depth;           ///< R32F, m; 0: nothing
    const gl::Texture& color;           ///< RGBA8, the colour camera's own picture
    const gl::Texture& backgroundDepth; ///< R32F, m, never 0
    const gl::Texture& backgroundColor; ///< RGBA8, a texel per texel of the grid
};

} // namespace autostereo::gpu
