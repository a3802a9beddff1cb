#pragma once

#include "calib/display_profile.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace autostereo::calib {

/// Sub-pixel -> view, as a phase in wrapping unsigned fixed point: 2^32 = one cycle (lens period).
/// phase(x, y, c) = columns[3x + c] + rows[y]; both tables are rounded once from extended
/// precision, so host and every GPU agree bit for bit and the error is at most 2^-32 cycle.
/// Value type; reentrant.
struct ViewMap {
    std::vector<std::uint32_t> columns; ///< 3 per column: R, G, B
    std::vector<std::uint32_t> rows;    ///< one per row, top row first
    std::uint32_t views = 1;
    bool reversed = false; ///< the vendor's view number falls as the eye moves right

    [[nodiscard]] std::uint32_t phase(int x, int y, int c) const {
        return columns[3 * static_cast<std::size_t>(x) + static_cast<std::size_t>(c)] +
               rows[static_cast<std::size_t>(y)];
    }
    /// View counted from the left, 0 .. views - 1.
    [[nodiscard]] std::uint32_t view(std::uint32_t phase) const {
        const auto vendor =
            static_cast<std::uint32_t>((static_cast<std::uint64_t>(phase) * views) >> 32);
        return reversed ? views - 1 - vendor : vendor;
    }
};

/// Tables for a panel of the given mode (the profile's own, or the monitor's for "preview").
[[nodiscard]] ViewMap makeViewMap(const DisplayProfile& display, int width, int height);

/// Position b in [-1, 1] of view i (counted from the left); b = +1 is the rightmost eye.
[[nodiscard]] double viewPosition(const DisplayProfile& display, int view);

} // namespace autostereo::calib
