#pragma once

#include "gpu/readback.hpp"
#include "tests/oracle/searched_panel.hpp"

#include <algorithm>
#include <cmath>

namespace autostereo::oracle {

struct Differences {
    double squares = 0, largest = 0;
    std::size_t samples = 0, overTwo = 0, unexplained = 0;

    void add(const Differences& more) {
        squares += more.squares;
        largest = std::max(largest, more.largest);
        samples += more.samples;
        overTwo += more.overTwo;
        unexplained += more.unexplained;
    }
    [[nodiscard]] double psnr() const {
        return 10 * std::log10(255 * 255 / (squares / static_cast<double>(samples)));
    }
};

/// More than two levels off only where the oracle itself goes there within a thousandth of a
/// sub-pixel: a silhouette that float and double put on either side, or a surface seen along
/// itself.
inline bool isTie(const SearchInput& in, const SearchedPanel& panel, int x, int y, int c,
                  double value) {
    constexpr double kShare = 1e-3 / 3;
    double least = 255, most = 0;
    for (const double right : {-kShare, 0.0, kShare})
        for (const double up : {-kShare, 0.0, kShare}) {
            const double beside = panel.level(in, x, y, c, right, up);
            least = std::min(least, beside);
            most = std::max(most, beside);
        }
    return value >= least - 2.5 && value <= most + 2.5;
}

inline Differences compare(const gpu::RgbImage& image, const SearchInput& in,
                           const SearchedPanel& panel, int rowStep) {
    Differences found;
    for (int y = rowStep / 2; y < image.height; y += rowStep)
        for (int x = 0; x < image.width; ++x)
            for (int c = 0; c < 3; ++c) {
                const double value = image.pixels[3 * (static_cast<std::size_t>(y) *
                                                           static_cast<std::size_t>(image.width) +
                                                       static_cast<std::size_t>(x)) +
                                                  static_cast<std::size_t>(c)];
                const double off = std::abs(value - panel.level(in, x, y, c));
                ++found.samples;
                found.squares += off * off;
                found.largest = std::max(found.largest, off);
                if (off <= 2.5) continue;
                ++found.overTwo;
                if (!isTie(in, panel, x, y, c, value)) ++found.unexplained;
            }
    return found;
}

} // namespace autostereo::oracle
