#include "gpu/views/kept_roots.hpp"

#include "gpu/gl/dispatch.hpp"

#include <array>

namespace autostereo::gpu {

namespace {

constexpr int kTile = 32;                                      // as in shaders/stale_tiles.glsl
constexpr std::array<std::uint32_t, 4> kNoSquares{4, 0, 0, 0}; // corners, squares, firsts

int tilesOf(int pixels) { return (pixels + kTile - 1) / kTile; }

std::vector<std::string> variant(bool upsideDown, int fringe) {
    std::vector<std::string> defines;
    if (upsideDown) defines.emplace_back("UPSIDE_DOWN");
    if (fringe > 0) defines.emplace_back("FRINGE");
    return defines;
}

} // namespace

KeptRoots::KeptRoots(int panelWidth, int panelHeight, const SearchParams& search, bool upsideDown,
                     int fringe)
    : tilesAcross_(tilesOf(panelWidth)), tilesDown_(tilesOf(panelHeight)),
      blocks_({"stale_blocks.comp"}), tiles_({"stale_tiles.comp"}, variant(upsideDown, 0)),
      colors_("kept_roots.frag", variant(upsideDown, fringe), panelWidth, panelHeight),
      roots_(GL_RG32UI, panelWidth, panelHeight), target_(gl::makeFramebuffer(roots_)),
      squares_(gl::makeBuffer(sizeof kNoSquares + sizeof(std::uint32_t) *
                                                      static_cast<std::size_t>(tilesAcross_) *
                                                      static_cast<std::size_t>(tilesDown_),
                              nullptr, GL_DYNAMIC_STORAGE_BIT)) {
    colors_.setSearch(search);
    colors_.block().edge.x = 1.0F / static_cast<float>(std::max(1, fringe));
}

void KeptRoots::findStale(const LayerSearch& search) {
    const gl::Texture& changed = search.changed();
    if (!stale_.isSized(changed.width(), changed.height() / 2))
        stale_ = gl::Texture(GL_R8UI, changed.width(), changed.height() / 2);
    takeCounts();
    glBindTextureUnit(0, changed.name());
    glBindImageTexture(0, stale_.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R8UI);
    gl::dispatch(blocks_, stale_.width(), stale_.height());
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);

    glNamedBufferSubData(squares_.name(), 0, sizeof kNoSquares, kNoSquares.data());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, squares_.name());
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, squares_.name());
    glBindTextureUnit(0, stale_.name());
    colors_.bindBlock();
    counters_.begin(1);
    gl::dispatch(tiles_, tilesAcross_, tilesDown_);
    counters_.end();
    glMemoryBarrier(GL_COMMAND_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
}

void KeptRoots::show(GLuint panel) {
    glBindTextureUnit(13, roots_.name());
    colors_.draw(nullptr, panel);
}

void KeptRoots::takeCounts() {
    while (const auto counts = counters_.take()) {
        searched_ += counts->front();
        ++frames_;
    }
}

std::optional<double> KeptRoots::keptShare() const {
    if (frames_ == 0) return std::nullopt;
    const double squares = static_cast<double>(tilesAcross_) * tilesDown_;
    return 1 - static_cast<double>(searched_) / (squares * static_cast<double>(frames_));
}

} // namespace autostereo::gpu
