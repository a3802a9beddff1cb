#pragma once

#include "gpu/fusion/cyclopean_scene.hpp"
#include "gpu/gl/program.hpp"
#include "gpu/mesh_layer.hpp"

namespace autostereo::gpu {

/// The cyclopean scene -> meshes, for the methods that draw triangles. Needs MeshBlock at binding
/// 0. Thread-bound.
class LayerMesher {
  public:
    /// Throws GlError.
    LayerMesher();
    /// Valid until the next call, and as long as the scene's textures.
    const MeshLayers& build(const CyclopeanScene& scene);

  private:
    void resize(int columns, int rows);

    gl::Program quads_, nodes_;
    MeshLayers layers_;
};

} // namespace autostereo::gpu
