#pragma once

#include "calib/solve/board.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace autostereo::calibrate {

/// A grey picture: gamma-encoded brightness 0 to 255, or a time-of-flight camera's amplitudes in
/// counts of any scale (65535: saturated). Top row first.
struct GreyImage {
    int width = 0;
    int height = 0;
    std::span<const std::uint16_t> values;
    bool isInfrared = false;
};

/// The board's corners, to a tenth of a pixel or so; none where it is not, or not wholly, in the
/// picture. Amplitudes fall with the square of the distance: they are stretched by their square
/// root. Pictures below a megapixel are enlarged first, because the detector's windows are too wide
/// for small squares. Pure; reentrant.
[[nodiscard]] std::optional<BoardView> findBoard(const GreyImage& image, const Board& board,
                                                 const std::string& name);

} // namespace autostereo::calibrate
