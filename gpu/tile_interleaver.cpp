#include "gpu/tile_interleaver.hpp"

#include <algorithm>
#include <iterator>

namespace autostereo::gpu {

namespace {

std::vector<std::string> variant(const InterleaverParams& params) {
    std::vector<std::string> defines;
    if (params.filter == TileFilter::Nearest) defines.emplace_back("NEAREST");
    std::ranges::move(definesOf(params.search), std::back_inserter(defines));
    return defines;
}

} // namespace

TileInterleaver::TileInterleaver(const calib::TileFrame& frame, int width, int height,
                                 const InterleaverParams& params)
    : pass_("tile_interleaver.frag", variant(params), width, height) {
    if (params.search) {
        pass_.block().fan.x = static_cast<std::uint32_t>(params.search->views);
        pass_.setSearch(*params.search);
    }
    pass_.block().fan.y = frame.topFirst ? 1U : 0U;
    pass_.block().fan.z = frame.swapped ? 1U : 0U;
    pass_.block().panel.z = frame.rows;
    pass_.block().panel.w = frame.columns;
}

void TileInterleaver::render(const DrawnViews& views, GLuint framebuffer) {
    if (views.atlas != nullptr)
        pass_.block().fan.x = static_cast<std::uint32_t>(views.atlas->layout().views);
    pass_.draw(views.atlas, framebuffer);
}

} // namespace autostereo::gpu
