#pragma once

#include "gpu/gl/counter_ring.hpp"
#include "gpu/gl/program.hpp"
#include "gpu/panel_pass.hpp"
#include "gpu/views/layer_search.hpp"

#include <optional>

namespace autostereo::gpu {

/// What each sub-pixel found last, kept for as long as nothing changes that its ray may come upon:
/// where only colours change nothing is searched. Needs MeshBlock at binding 0. Thread-bound.
class KeptRoots {
  public:
    /// For a panel of that size. Throws GlError.
    KeptRoots(int panelWidth, int panelHeight, const SearchParams& search, bool upsideDown,
              int fringe);
    /// Lists the squares to search, for the draw that fills `target` (Cover::StaleTiles). After
    /// LayerSearch::build.
    void findStale(const LayerSearch& search);
    [[nodiscard]] GLuint target() const { return target_.name(); }
    /// The panel's colours from what is in `target`.
    void show(GLuint panel);
    /// Share of the panel that was not searched, mean of the frames counted so far.
    [[nodiscard]] std::optional<double> keptShare() const;

  private:
    void takeCounts();

    int tilesAcross_, tilesDown_;
    gl::Program blocks_, tiles_;
    PanelPass colors_;
    gl::Texture stale_; ///< R8UI, a texel a block
    gl::Texture roots_; ///< RG32UI, a texel a pixel
    gl::Framebuffer target_;
    gl::Buffer squares_; ///< indirect draw, then one number a square
    gl::CounterRing counters_{1};
    std::uint64_t searched_ = 0, frames_ = 0;
};

} // namespace autostereo::gpu
