#include "gpu/views/kept_roots.hpp"

#include "gpu/gl/dispatch.hpp"

#include <array>

namespace autostereo::gpu {

namespace {

constexpr int kTileWidth = 64, kTileHeight = 16;             // as in shaders/stale_tiles.glsl
constexpr std::array<std::uint32_t, 4> kNoTiles{4, 0, 0, 0}; // corners, tiles, firsts

int tilesOf(int pixels, int tile) { return (pixels + tile - 1) / tile; }

std::vector<std::string> variant(bool upsideDown, int fringe) {
    std::vector<std::string> defines;
    if (upsideDown) defines.emplace_back("UPSIDE_DOWN");
    if (fringe > 0) defines.emplace_back("FRINGE");
    return defines;
}

gl::Buffer makeList(int tiles) {
    return gl::makeBuffer(sizeof kNoTiles + sizeof(std::uint32_t) * static_cast<std::size_t>(tiles),
                          nullptr, GL_DYNAMIC_STORAGE_BIT);
}

} // namespace

KeptRoots::KeptRoots(int panelWidth, int panelHeight, const SearchParams& search, bool upsideDown,
                     int fringe)
    : tilesAcross_(tilesOf(panelWidth, kTileWidth)), tilesDown_(tilesOf(panelHeight, kTileHeight)),
      tiles_({"stale_tiles.comp"}, variant(upsideDown, 0)),
      colors_("kept_roots.frag", variant(upsideDown, fringe), panelWidth, panelHeight,
              Cover::StaleTiles),
      roots_(GL_RG32UI, panelWidth, panelHeight), target_(gl::makeFramebuffer(roots_)),
      picture_(GL_RGBA8, panelWidth, panelHeight), shown_(gl::makeFramebuffer(picture_)),
      everywhere_(GL_R8UI, 1, 1), toSearch_(makeList(tilesAcross_ * tilesDown_)),
      toRecolor_(makeList(tilesAcross_ * tilesDown_)) {
    colors_.setSearch(search);
    colors_.block().edge.x = 1.0F / static_cast<float>(std::max(1, fringe));
    const std::uint8_t mark = 1;
    glClearTexImage(everywhere_.name(), 0, GL_RED_INTEGER, GL_UNSIGNED_BYTE, &mark);
}

void KeptRoots::clearLists() const {
    for (const gl::Buffer* list : {&toSearch_, &toRecolor_})
        glNamedBufferSubData(list->name(), 0, sizeof kNoTiles, kNoTiles.data());
}

void KeptRoots::findStale(const LayerSearch& search, const BlockMarks* colors) {
    takeCounts();
    clearLists();
    glBindTextureUnit(0, search.changed().name());
    glBindTextureUnit(1, search.changedBlocks().texture().name());
    glBindTextureUnit(2, (colors != nullptr ? colors->texture() : everywhere_).name());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, toSearch_.name());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 3, toRecolor_.name());
    colors_.bindBlock();
    counters_.begin(1);
    gl::dispatch(tiles_, tilesAcross_, tilesDown_);
    counters_.end();
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, toSearch_.name());
    glMemoryBarrier(GL_COMMAND_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
}

void KeptRoots::show(GLuint panel) {
    glBindTextureUnit(13, roots_.name());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, toRecolor_.name());
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, toRecolor_.name());
    colors_.draw(nullptr, shown_.name());
    glBlitNamedFramebuffer(shown_.name(), panel, 0, 0, picture_.width(), picture_.height(), 0, 0,
                           picture_.width(), picture_.height(), GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void KeptRoots::takeCounts() {
    while (const auto counts = counters_.take()) {
        searched_ += counts->front();
        recolored_ += counts->back();
        ++frames_;
    }
}

std::optional<KeptShare> KeptRoots::keptShare() const {
    if (frames_ == 0) return std::nullopt;
    const double tiles = static_cast<double>(tilesAcross_) * tilesDown_;
    const double all = tiles * static_cast<double>(frames_);
    return KeptShare{1 - static_cast<double>(searched_) / all,
                     1 - static_cast<double>(recolored_) / all};
}

} // namespace autostereo::gpu
