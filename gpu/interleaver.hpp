#pragma once

#include "calib/view_map.hpp"
#include "gpu/atlas.hpp"
#include "gpu/blocks.hpp"
#include "gpu/gl/program.hpp"
#include "gpu/gl/uniform_buffer.hpp"
#include "gpu/params.hpp"

namespace autostereo::gpu {

/// Atlas -> panel: every sub-pixel reads its channel from its view's tile (the Combiner of Kooima
/// 2007, for lens sheets). Which view is decided in fixed point, bit for bit as ViewMap does on the
/// host. Draws over the whole target. Thread-bound.
class Interleaver {
  public:
    /// `map` has the size of the panel. Throws GlError.
    Interleaver(const calib::ViewMap& map, TileFilter filter);
    void render(const Atlas& atlas, GLuint framebuffer);

  private:
    int width_, height_;
    InterleaverBlock block_;
    gl::UniformBuffer<InterleaverBlock> uniforms_;
    gl::Program program_;
    gl::Texture columnPhases_; ///< RGBA32UI, one texel a column
    gl::Texture rowPhases_;    ///< R32UI, one texel a row
    gl::VertexArray vertexArray_;
};

} // namespace autostereo::gpu
