#pragma once

#include "calib/display_laws.hpp"

namespace autostereo::calib {

/// View of a panel pixel (from the top left) where whole views lie in tiles of floor(panel / count)
/// pixels; -1 in what is left over and in tiles without a view.
[[nodiscard]] constexpr int tileView(const TileFrame& frame, int views, int width, int height,
                                     int x, int y) {
    const int column = x / (width / frame.columns);
    const int row = (frame.topFirst ? y : height - 1 - y) / (height / frame.rows);
    const int view = row * frame.columns + column;
    if (column >= frame.columns || row >= frame.rows || view >= views) return -1;
    return frame.swapped ? views - 1 - view : view;
}

} // namespace autostereo::calib
