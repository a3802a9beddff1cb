#pragma once

#include "gpu/gl/counter_ring.hpp"
#include "gpu/gl/program.hpp"
#include "gpu/panel_pass.hpp"
#include "gpu/panel_tiles.hpp"
#include "gpu/views/kept_share.hpp"
#include "gpu/views/layer_search.hpp"

#include <optional>

namespace autostereo::gpu {

/// What each sub-pixel found last, and the picture that it gave, kept for as long as nothing
/// changes that its ray may come upon: where only colours change nothing is searched, and where
/// nothing does nothing is drawn. Needs MeshBlock at binding 0. Thread-bound.
class KeptRoots {
  public:
    /// For a panel of that size. Throws GlError.
    KeptRoots(int panelWidth, int panelHeight, const SearchParams& search, bool upsideDown,
              int fringe);
    /// Lists the tiles to search, for the draw that fills `target` (Cover::StaleTiles). After
    /// LayerSearch::build. `colors`: where colours changed; none: perhaps everywhere.
    void findStale(const LayerSearch& search, const BlockMarks* colors);
    [[nodiscard]] GLuint target() const { return target_.name(); }
    /// The panel's colours from what is in `target`.
    void show(GLuint panel);
    /// None before the first frame was counted.
    [[nodiscard]] std::optional<KeptShare> keptShare() const;

  private:
    void takeCounts();

    gl::Program tiles_;
    PanelPass colors_;
    gl::Texture roots_; ///< RG32UI, a texel a pixel
    gl::Framebuffer target_;
    gl::Texture picture_; ///< RGBA8
    gl::Framebuffer shown_;
    gl::Texture everywhere_; ///< marks all colours
    PanelTiles toSearch_, toRecolor_;
    gl::CounterRing counters_{2};
    std::uint64_t searched_ = 0, recolored_ = 0, frames_ = 0;
};

} // namespace autostereo::gpu
