#include "gpu/interleaver.hpp"

#include "gpu/band_interleaver.hpp"
#include "gpu/depth_frame_packer.hpp"
#include "gpu/tile_interleaver.hpp"
#include "gpu/view_interleaver.hpp"

namespace autostereo::gpu {

std::unique_ptr<Interleaver> makeInterleaver(const calib::PanelMap& map, int width, int height,
                                             const InterleaverParams& params) {
    if (const auto* bands = std::get_if<calib::BandMap>(&map))
        return std::make_unique<BandInterleaver>(*bands, params);
    if (const auto* tiles = std::get_if<calib::TileFrame>(&map))
        return std::make_unique<TileInterleaver>(*tiles, width, height, params);
    if (const auto* frame = std::get_if<calib::DepthFrame>(&map))
        return std::make_unique<DepthFramePacker>(*frame, width, height);
    return std::make_unique<ViewInterleaver>(std::get<calib::ViewMap>(map), params);
}

} // namespace autostereo::gpu
