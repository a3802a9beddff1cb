#pragma once

#include "gpu/atlas.hpp"
#include "gpu/blocks.hpp"
#include "gpu/gl/program.hpp"
#include "gpu/gl/uniform_buffer.hpp"
#include "gpu/search_params.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace autostereo::gpu {

/// What a pass draws: all of the panel, or what KeptRoots lists.
enum class Cover { Panel, StaleTiles };

/// What every interleaver does alike: one triangle over the panel that reads the atlas' tiles, or
/// searches the layers.
/// Thread-bound.
class PanelPass {
  public:
    /// Throws GlError.
    PanelPass(const std::string& fragmentShader, const std::vector<std::string>& defines, int width,
              int height, Cover cover = Cover::Panel);

    /// Set once, before drawing; the tiles' sizes are filled in per draw.
    InterleaverBlock& block() { return block_; }
    void setSearch(const SearchParams& params);
    /// For compute shaders that ask about the panel.
    void bindBlock() { uniforms_.bind(2, block_); }
    /// Textures beyond the atlas are bound by the caller; without one, all of them.
    void draw(const Atlas* atlas, GLuint framebuffer);

  private:
    void useTiles(const Atlas& atlas);

    int width_, height_;
    Cover cover_;
    InterleaverBlock block_;
    gl::UniformBuffer<InterleaverBlock> uniforms_;
    gl::Program program_;
    gl::VertexArray vertexArray_;
};

/// A table of unsigned numbers as a texture: 1, 2 or 3 channels (3 are stored as 4).
[[nodiscard]] gl::Texture tableTexture(int channels, int width, int height,
                                       const std::uint32_t* numbers);

} // namespace autostereo::gpu
