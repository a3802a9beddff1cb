#pragma once

#include "calib/panel_map.hpp"
#include "gpu/atlas.hpp"
#include "gpu/params.hpp"
#include "gpu/search_params.hpp"

#include <memory>
#include <optional>

namespace autostereo::gpu {

/// What the panel is filled from; nothing where the layers are searched.
struct DrawnViews {
    const Atlas* atlas = nullptr;
    const gl::Texture* disparity = nullptr; ///< R32F, tile-sized; depth frames only
};

/// Views -> panel (the Combiner of Kooima 2007, for every display family). One file per kind of
/// PanelMap; all read tiles by shaders/interleaver_block.glsl. Draws over the whole target.
/// Thread-bound.
class Interleaver {
  public:
    virtual ~Interleaver() = default;
    virtual void render(const DrawnViews& views, GLuint framebuffer) = 0;
};

struct InterleaverParams {
    TileFilter filter = TileFilter::Linear;
    ViewFilter views = ViewFilter::Nearest;
    int fringe = 0;                       ///< pixels of fade at the panel's border
    std::optional<SearchParams> search{}; ///< in place of tiles
};

/// Throws GlError.
[[nodiscard]] std::unique_ptr<Interleaver>
makeInterleaver(const calib::PanelMap& map, int width, int height, const InterleaverParams& params);

} // namespace autostereo::gpu
