#pragma once

#include "calib/display_profile.hpp"
#include "calib/view_map.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace autostereo::calib {

/// Texels of a quilt that some sub-pixel shows: what need not be drawn at all is known once the
/// display is (15 to 78 % of a quilt).
struct TexelMask {
    int width = 0; ///< of all tiles together
    int height = 0;
    std::vector<std::uint8_t> channels; ///< bits 0, 1, 2: R, G, B are shown; top row first

    [[nodiscard]] std::size_t texelsRead() const;
    [[nodiscard]] std::size_t channelsRead() const;
};

/// `neighbours`: the four texels around a sub-pixel's place count (linear filter), else the one
/// that it lies in.
[[nodiscard]] TexelMask texelMask(const ViewMap& map, const QuiltLayout& quilt, bool neighbours);

} // namespace autostereo::calib
