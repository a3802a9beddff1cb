#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace autostereo::calib {

/// A letter on a grid of cells: 5 across, rows from two above a capital's top to two below the
/// line. Bit 4 of a row is its leftmost cell.
struct Glyph {
    static constexpr int kWidth = 5;
    static constexpr int kHeight = 11;
    std::array<std::uint8_t, kHeight> rows{};

    [[nodiscard]] bool has(int column, int row) const {
        return (rows.at(static_cast<std::size_t>(row)) >> (kWidth - 1 - column) & 1U) != 0;
    }
    [[nodiscard]] bool operator==(const Glyph&) const = default;
};

/// ASCII and the letters of Western European languages; a box for all else. Reentrant.
[[nodiscard]] Glyph glyphOf(char32_t letter);

/// Letters of a UTF-8 text; U+FFFD for every byte that is none of one.
[[nodiscard]] std::u32string lettersOf(std::string_view utf8);

} // namespace autostereo::calib
