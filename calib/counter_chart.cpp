#include "calib/counter_chart.hpp"

#include <algorithm>

namespace autostereo::calib {

namespace {

// A chessboard of so many squares, and one of white around it.
constexpr int kBoardColumns = CounterChart::kCornerColumns + 3;
constexpr int kBoardRows = CounterChart::kCornerRows + 3;
constexpr int kColumns = 5, kRows = 4;
static_assert(kColumns * kRows == 2 * CounterChart::kBits);

template<class IsWhite>
Picture painted(int width, int height, const IsWhite& isWhite) {
    Picture picture{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::uint8_t level = isWhite(x, y) ? 255 : 0;
            picture.pixels.insert(picture.pixels.end(), {level, level, level, 255});
        }
    return picture;
}

} // namespace

Picture CounterChart::board() {
    return painted(kBoardColumns, kBoardRows, [](int x, int y) {
        const bool margin = x == 0 || y == 0 || x == kBoardColumns - 1 || y == kBoardRows - 1;
        return margin || (x + y) % 2 != 0;
    });
}

glm::dvec2 CounterChart::corner(int column, int row) {
    return glm::dvec2(column + 2, row + 2) / glm::dvec2(kBoardColumns, kBoardRows);
}

Picture CounterChart::blocks(unsigned number) {
    const unsigned gray = grayOf(number);
    return painted(kColumns, kRows, [gray](int x, int y) {
        const int bit = x + kColumns * (y / 2);
        return ((gray >> static_cast<unsigned>(bit) & 1U) != 0) == (y % 2 == 0);
    });
}

glm::dvec2 CounterChart::blockOf(int bit, bool inverse) {
    const glm::dvec2 block(bit % kColumns, 2 * (bit / kColumns) + (inverse ? 1 : 0));
    return (block + 0.5) / glm::dvec2(kColumns, kRows);
}

glm::dvec2 CounterChart::halfBlock() { return 0.5 / glm::dvec2(kColumns, kRows); }

unsigned CounterChart::numberOf(unsigned gray) {
    unsigned number = gray;
    for (int shift = 1; shift < kBits; shift *= 2)
        number ^= number >> static_cast<unsigned>(shift);
    return number;
}

} // namespace autostereo::calib
