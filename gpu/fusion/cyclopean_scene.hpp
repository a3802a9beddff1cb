#pragma once

#include "gpu/dirty/block_marks.hpp"

namespace autostereo::gpu {

/// Where a scene may differ from the one before it, in blocks of the grid.
struct SceneChanges {
    BlockMarks depth; ///< of either layer
    BlockMarks color; ///< of what either layer shows
};

/// What the views are made from: one clean picture of the scene and of what stands behind it, on
/// the cyclopean grid. The textures are their owners'.
struct CyclopeanScene {
    const gl::Texture& depth;              ///< R32F, m; 0: nothing
    const gl::Texture& color;              ///< RGBA8, the colour camera's own picture
    const gl::Texture& backgroundDepth;    ///< R32F, m, never 0
    const gl::Texture& backgroundColor;    ///< RGBA8, a texel per texel of the grid
    const SceneChanges* changes = nullptr; ///< none: it may differ everywhere
};

} // namespace autostereo::gpu
