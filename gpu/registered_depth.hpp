#pragma once

#include "gpu/gl/program.hpp"
#include "gpu/mesh_layer.hpp"

namespace autostereo::gpu {

/// Nearest depth at the colour camera: a mesh drawn from there with a depth test (de Sorbier 2010,
/// section II.C). Compute shaders draw: the triangles are a few pixels large, for which they are
/// faster than the rasteriser. Whatever the order of triangles, the result is the same to the bit.
/// The mesh block is bound by the caller. Thread-bound.
class RegisteredDepth {
  public:
    /// What can be drawn; all as large as each other.
    struct Grid {
        const MeshLayer& nodes;
        const gl::Texture& counts;         ///< R16UI
        const gl::Texture* rays = nullptr; ///< RG32F; only passes that draw between nodes need it
    };

    RegisteredDepth();

    /// Starts a picture of that size.
    void clear(int width, int height);
    /// `pass`: a variant of register_mesh.comp.
    void drawMesh(const gl::Program& pass, const Grid& grid);
    /// `pass`: a variant of register_cuts.comp; `cuts`: the list that register_mesh.comp made.
    void drawCuts(const gl::Program& pass, const Grid& grid, const gl::Buffer& cuts);
    /// Finishes the picture.
    void resolve();
    /// R32F, metres, 0: none; top row first.
    [[nodiscard]] const gl::Texture& metres() const { return metres_; }

  private:
    void use(const gl::Program& pass, const Grid& grid) const;

    gl::Program resolve_;
    gl::Texture keys_; ///< R32UI, shaders/registered_keys.glsl
    gl::Texture metres_;
};

} // namespace autostereo::gpu
