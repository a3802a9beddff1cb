#pragma once

#include "calib/solve/board.hpp"

#include <cstdint>
#include <string>

namespace autostereo::calibrate {

/// Somebody else's 8-bit picture, rows tightly packed.
struct GreyBytes {
    int width;
    int height;
    std::uint8_t* pixels;
};

/// Corners between recognised markers, as many as are seen. Throws Refusal where the program was
/// built without OpenCV's aruco module.
[[nodiscard]] BoardView findCharuco(const GreyBytes& picture, const Board& board,
                                    const std::string& name);

} // namespace autostereo::calibrate
