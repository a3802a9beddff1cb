#include "gpu/tile_interleaver.hpp"

namespace autostereo::gpu {

TileInterleaver::TileInterleaver(const calib::TileFrame& frame, int width, int height,
                                 const InterleaverParams& params)
    : pass_("tile_interleaver.frag",
            params.filter == TileFilter::Nearest ? std::vector<std::string>{"NEAREST"}
                                                 : std::vector<std::string>{},
            width, height) {
    pass_.block().fan.y = frame.topFirst ? 1U : 0U;
    pass_.block().fan.z = frame.swapped ? 1U : 0U;
    pass_.block().panel.z = frame.rows;
    pass_.block().panel.w = frame.columns;
}

void TileInterleaver::render(const DrawnViews& views, GLuint framebuffer) {
    pass_.block().fan.x = static_cast<std::uint32_t>(views.atlas->layout().views);
    pass_.draw(*views.atlas, framebuffer);
}

} // namespace autostereo::gpu
