#pragma once

#include "gpu/atlas.hpp"
#include "gpu/mesh_layer.hpp"

namespace autostereo::gpu {

/// Mesh layers -> all views in the atlas. One file per method; all share the mesh, the shaders and
/// the tile layout, and give the same picture to rounding. Thread-bound.
class AtlasViews {
  public:
    virtual ~AtlasViews() = default;
    virtual void render(const MeshLayers& layers, const gl::Texture& color, const Atlas& atlas) = 0;
};

/// Triangles are cut to their tile by its four edges (gl_ClipDistance), while this lives.
class ClippedToTiles {
  public:
    ClippedToTiles() { each(glEnable); }
    ~ClippedToTiles() { each(glDisable); }
    ClippedToTiles(const ClippedToTiles&) = delete;
    ClippedToTiles& operator=(const ClippedToTiles&) = delete;

  private:
    template<class Switch>
    static void each(Switch turn) {
        constexpr GLenum kTileEdges = 4;
        for (GLenum edge = 0; edge < kTileEdges; ++edge)
            turn(GL_CLIP_DISTANCE0 + edge);
    }
};

} // namespace autostereo::gpu
