#pragma once

#include "gpu/params.hpp"
#include "tests/oracle/display_oracle.hpp"
#include "tests/oracle/view_oracle.hpp"

// Slow, obvious twin of the interleaver: all views' tiles -> panel, phase in extended precision.

namespace autostereo::oracle {

/// `tiles`: one picture per view, all of one size.
inline Picture interleave(const calib::DisplayProfile& display, const std::vector<Picture>& tiles,
                          int width, int height, gpu::TileFilter filter) {
    Picture panel{width, height, {}};
    const PhaseFunction phaseOf = phaseFunction(display);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            std::array<double, 3> pixel{};
            for (int c = 0; c < 3; ++c) {
                const Picture& tile =
                    tiles[static_cast<std::size_t>(viewOf(display, phaseOf(x, y, c)))];
                const double tx = (x + 0.5) * tile.width / width - 0.5;
                const double ty = (y + 0.5) * tile.height / height - 0.5;
                const auto channel = static_cast<std::size_t>(c);
                pixel[channel] = filter == gpu::TileFilter::Nearest
                                     ? tile.at(static_cast<int>(std::floor(tx + 0.5)),
                                               static_cast<int>(std::floor(ty + 0.5)))[channel]
                                     : tile.sample(tx, ty)[channel];
            }
            panel.pixels.push_back(pixel);
        }
    return panel;
}

} // namespace autostereo::oracle
