#pragma once

#include "calib/picture.hpp"

#include <glm/vec2.hpp>

namespace autostereo::calib {

/// What a camera in front of a panel reads when its delay is measured: first a chessboard, which
/// says where the panel lies in the picture, then numbers in blocks. In Gray code (US 2 632 058),
/// so that a picture taken while one number follows another leaves a single bit in doubt, and each
/// bit above its inverse, so that reading it needs no threshold. The pictures have a pixel a block,
/// to be stretched over the whole panel, the same in every view. Places are shares of the panel's
/// width and height from its upper left corner. Pure.
struct CounterChart {
    static constexpr int kCornerColumns = 9, kCornerRows = 6; ///< of the board, inner ones
    static constexpr int kBits = 10;
    static constexpr unsigned kNumbers = 1U << kBits;

    [[nodiscard]] static Picture board();
    /// Of the board, by rows from the upper left.
    [[nodiscard]] static glm::dvec2 corner(int column, int row);

    /// `number` below kNumbers.
    [[nodiscard]] static Picture blocks(unsigned number);
    /// The middle of a bit's block or its inverse's, and half a block's width and height.
    [[nodiscard]] static glm::dvec2 blockOf(int bit, bool inverse);
    [[nodiscard]] static glm::dvec2 halfBlock();

    [[nodiscard]] static unsigned grayOf(unsigned number) { return number ^ (number >> 1U); }
    [[nodiscard]] static unsigned numberOf(unsigned gray);
};

} // namespace autostereo::calib
