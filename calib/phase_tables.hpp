#pragma once

#include "calib/display_laws.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace autostereo::calib {

/// Cycles -> 2^-32 cycles, wrapping; rounded once. Long double carries 64 bits of mantissa, so
/// reducing a phase of some thousand cycles loses nothing that 32 fractional bits could show.
[[nodiscard]] std::uint32_t turns(long double cycles);

/// An affine phase in whole numbers, wrapping: columns and rows in 2^-48 cycle, summed exactly and
/// rounded once to 2^-32, the channel's share rounded on its own. The coefficients' rounding adds
/// at most 2^-49 cycle per column and row, so that a phase of 16384 x 16384 pixels is within
/// 1.25 * 2^-32 cycle. A GPU does the same in two halves of 32 and 16 bits
/// (shaders/affine_phase.glsl), to the bit.
struct AffinePhase {
    static constexpr int kCells = 8; ///< patterns repeat every 2 columns and 4 rows

    std::uint64_t perColumn = 0;
    std::uint64_t perRow = 0;
    /// With the offset in them, 2^-32: [(y mod 4) * 2 + x mod 2][c], rows from the top.
    std::array<std::array<std::uint32_t, 3>, kCells> channels{};

    [[nodiscard]] std::uint32_t at(int x, int y, int c) const {
        const auto column = static_cast<std::uint64_t>(x), row = static_cast<std::uint64_t>(y);
        const std::size_t cell = 2 * (row & 3) + (column & 1);
        const std::uint64_t sum = perColumn * column + perRow * row + 0x8000;
        return static_cast<std::uint32_t>(sum >> 16) + channels[cell][static_cast<std::size_t>(c)];
    }
};

/// A phase grid in whole numbers, so that host and GPU interpolate it to the same bit.
struct GridTables {
    /// Left or upper node, and how far from it to the next one in 2^-31.
    struct Place {
        std::uint32_t node = 0;
        std::uint32_t weight = 0;
    };
    int columns = 0; ///< nodes
    int rows = 0;
    std::vector<std::uint32_t> nodes; ///< 2^32 = one cycle, row by row from the top
    std::vector<Place> columnPlaces;  ///< one per pixel column
    std::vector<Place> rowPlaces;

    [[nodiscard]] std::uint32_t at(int x, int y) const;
};

/// A small pattern of phases that repeats over the panel from the top left.
struct PatternTable {
    int rows = 0;
    std::vector<std::uint32_t> phases; ///< rows x panel width x 3
};

/// Phase of every sub-pixel in wrapping unsigned fixed point, 2^32 = one cycle: affine plus grid,
/// or a repeating pattern, or a LUT of the whole panel. Host and every GPU agree bit for bit. Value
/// type; reentrant.
struct PhaseTables {
    PhaseTables() = default;
    PhaseTables(int panelWidth, int panelHeight) : width(panelWidth), height(panelHeight) {}

    int width = 0;
    int height = 0;
    AffinePhase affine;
    GridTables grid;                                       ///< without nodes: none
    PatternTable pattern;                                  ///< with rows: replaces affine
    std::shared_ptr<const std::vector<std::uint32_t>> lut; ///< height x width x 3; replaces all

    [[nodiscard]] std::uint32_t phase(int x, int y, int c) const {
        if (lut) return (*lut)[subpixel(x, y, c)];
        if (pattern.rows > 0) return pattern.phases[subpixel(x, y % pattern.rows, c)];
        const std::uint32_t sum = affine.at(x, y, c);
        return grid.nodes.empty() ? sum : sum + grid.at(x, y);
    }

  private:
    [[nodiscard]] std::size_t subpixel(int x, int y, int c) const {
        return 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                    static_cast<std::size_t>(x)) +
               static_cast<std::size_t>(c);
    }
};

[[nodiscard]] PhaseTables phaseTables(const LinearPhase& law, int width, int height);
/// A sub-pixel's phase is the middle of its view.
[[nodiscard]] PhaseTables phaseTables(const ViewTable& table, int views, int width, int height);

} // namespace autostereo::calib
