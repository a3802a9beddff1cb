#pragma once

#include "gpu/gl/objects.hpp"
#include "gpu/gl/program.hpp"

#include <span>

namespace autostereo::gpu {

/// Nearest depth at the colour camera: a mesh drawn from there with a depth test (de Sorbier 2010,
/// section II.C). Compute shaders draw: the triangles are a few pixels large, for which they are
/// faster than the rasteriser. Whatever the order of triangles, the result is the same to the bit.
/// The mesh block is bound by the caller. Thread-bound.
class RegisteredDepth {
  public:
    /// Textures of a depth grid, all of its size, in the units that shaders/registered_nodes.glsl
    /// says.
    using Grid = std::span<const gl::Texture* const>;

    RegisteredDepth();

    /// Starts a picture of that size.
    void clear(int width, int height);
    /// `pass`: a variant of register_mesh.comp.
    void drawMesh(const gl::Program& pass, Grid grid);
    /// `pass`: a variant of register_cuts.comp; `cuts`: the list that register_mesh.comp made.
    void drawCuts(const gl::Program& pass, Grid grid, const gl::Buffer& cuts);
    /// Finishes the picture.
    void resolve();
    /// R32F, metres, 0: none; top row first.
    [[nodiscard]] const gl::Texture& metres() const { return metres_; }

  private:
    void use(const gl::Program& pass, Grid grid) const;

    gl::Program resolve_;
    gl::Texture keys_; ///< R32UI, shaders/registered_keys.glsl
    gl::Texture metres_;
    gl::Framebuffer framebuffer_; ///< of metres_
    gl::VertexArray vertexArray_; ///< no attributes
};

} // namespace autostereo::gpu
