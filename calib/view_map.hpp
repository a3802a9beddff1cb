#pragma once

#include "calib/display_profile.hpp"
#include "calib/phase_tables.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace autostereo::calib {

/// Sub-pixel -> view, for every display whose views do not depend on where its viewers are.
/// Value type; reentrant.
struct ViewMap {
    static constexpr std::uint32_t kBlack = 0xffff;

    PhaseTables tables;
    std::uint32_t views = 1; ///< vendor's
    bool reversed = false;   ///< the vendor's view number falls as the eye moves right
    bool upsideDown = false; ///< the panel scans from the bottom: rows of the picture turn round
    /// Of each vendor's view: the view from the left that it shows, or kBlack. Empty: each its own.
    std::vector<std::uint32_t> remap;

    [[nodiscard]] std::uint32_t phase(int x, int y, int c) const { return tables.phase(x, y, c); }
    /// View counted from the left, 0 .. views - 1, or kBlack.
    [[nodiscard]] std::uint32_t view(std::uint32_t phase) const {
        const auto vendor =
            static_cast<std::uint32_t>((static_cast<std::uint64_t>(phase) * views) >> 32);
        if (!remap.empty()) return remap[vendor];
        return reversed ? views - 1 - vendor : vendor;
    }
};

/// Position b in [-1, 1] of view i (counted from the left); b = +1 is the rightmost eye.
[[nodiscard]] double viewPosition(const DisplayProfile& display, int view);

} // namespace autostereo::calib
