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

} // namespace autostereo::gpu
