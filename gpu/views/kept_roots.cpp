#include "gpu/views/kept_roots.hpp"

#include "gpu/gl/dispatch.hpp"

namespace autostereo::gpu {

namespace {

std::vector<std::string> variant(bool upsideDown, int fringe) {
    std::vector<std::string> defines;
    if (upsideDown) defines.emplace_back("UPSIDE_DOWN");
    if (fringe > 0) defines.emplace_back("FRINGE");
    return defines;
}

} // namespace

KeptRoots::KeptRoots(int panelWidth, int panelHeight, const SearchParams& search, bool upsideDown,
                     int fringe)
    : tiles_({"stale_tiles.comp"}, variant(upsideDown, 0)),
      colors_("kept_roots.frag", variant(upsideDown, fringe), panelWidth, panelHeight,
              Cover::StaleTiles),
      roots_(GL_RG32UI, panelWidth, panelHeight), target_(gl::makeFramebuffer(roots_)),
      picture_(GL_RGBA8, panelWidth, panelHeight), shown_(gl::makeFramebuffer(picture_)),
      everywhere_(GL_R8UI, 1, 1), toSearch_(panelWidth, panelHeight),
      toRecolor_(panelWidth, panelHeight) {
    colors_.setSearch(search);
    colors_.block().edge.x = 1.0F / static_cast<float>(std::max(1, fringe));
    const std::uint8_t mark = 1;
    glClearTexImage(everywhere_.name(), 0, GL_RED_INTEGER, GL_UNSIGNED_BYTE, &mark);
}

void KeptRoots::findStale(const LayerSearch& search, const BlockMarks* colors) {
    takeCounts();
    toSearch_.clear();
    toRecolor_.clear();
    glBindTextureUnit(0, search.changed().name());
    glBindTextureUnit(1, search.changedBlocks().texture().name());
    glBindTextureUnit(2, (colors != nullptr ? colors->texture() : everywhere_).name());
    toSearch_.bind(2);
    toRecolor_.bind(3);
    colors_.bindBlock();
    counters_.begin(1);
    gl::dispatch(tiles_, toSearch_.across(), toSearch_.down());
    counters_.end();
    toSearch_.bindToDraw();
    glMemoryBarrier(GL_COMMAND_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
}

void KeptRoots::show(GLuint panel) {
    glBindTextureUnit(13, roots_.name());
    toRecolor_.bindToDraw();
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
    const double tiles = static_cast<double>(toSearch_.across()) * toSearch_.down();
    const double all = tiles * static_cast<double>(frames_);
    return KeptShare{1 - static_cast<double>(searched_) / all,
                     1 - static_cast<double>(recolored_) / all};
}

} // namespace autostereo::gpu
