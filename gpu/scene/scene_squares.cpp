#include "gpu/scene/scene_squares.hpp"

#include "gpu/gl/dispatch.hpp"

#include <array>
#include <string>
#include <vector>

namespace autostereo::gpu {

namespace {

constexpr int kTile = 32;                                      // as in shaders/stale_tiles.glsl
constexpr std::array<std::uint32_t, 4> kNoSquares{4, 0, 0, 0}; // corners, squares, firsts

int squaresOf(int pixels) { return (pixels + kTile - 1) / kTile; }

std::vector<std::string> variant(bool upsideDown) {
    if (upsideDown) return {"UPSIDE_DOWN"};
    return {};
}

} // namespace

SceneSquares::SceneSquares(int panelWidth, int panelHeight, const SearchParams& search,
                           bool upsideDown)
    : across_(squaresOf(panelWidth)), down_(squaresOf(panelHeight)),
      program_({"scene_squares.comp"}, variant(upsideDown)),
      squares_(gl::makeBuffer(sizeof kNoSquares + sizeof(std::uint32_t) *
                                                      static_cast<std::size_t>(across_) *
                                                      static_cast<std::size_t>(down_),
                              nullptr, GL_DYNAMIC_STORAGE_BIT)) {
    block_.panel = {panelWidth, panelHeight, 1, 1};
    block_.fine = {1.0F / static_cast<float>(panelWidth), 1.0F / static_cast<float>(panelHeight),
                   static_cast<float>(search.channelStep), 0.0F};
}

void SceneSquares::list() {
    glNamedBufferSubData(squares_.name(), 0, sizeof kNoSquares, kNoSquares.data());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, squares_.name());
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, squares_.name());
    uniforms_.bind(2, block_);
    gl::dispatch(program_, across_, down_);
    glMemoryBarrier(GL_COMMAND_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
}

} // namespace autostereo::gpu
