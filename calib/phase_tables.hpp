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

/// Phase of every sub-pixel in wrapping unsigned fixed point, 2^32 = one cycle:
/// phase(x, y, c) = columns[y mod rowPeriod][x][c] + rows[y] + grid(x, y), or lut[y][x][c].
/// Tables are rounded once from extended precision: without a grid the error is at most 2^-32
/// cycle, and host and every GPU agree bit for bit. Value type; reentrant.
struct PhaseTables {
    PhaseTables() = default;
    PhaseTables(int panelWidth, int panelHeight) : width(panelWidth), height(panelHeight) {}

    int width = 0;
    int height = 0;
    int rowPeriod = 1;
    std::vector<std::uint32_t> columns;                    ///< rowPeriod x width x 3
    std::vector<std::uint32_t> rows;                       ///< one per row, top row first
    GridTables grid;                                       ///< without nodes: none
    std::shared_ptr<const std::vector<std::uint32_t>> lut; ///< height x width x 3; replaces all

    [[nodiscard]] std::uint32_t phase(int x, int y, int c) const {
        const auto pixel = static_cast<std::size_t>(x), row = static_cast<std::size_t>(y),
                   channel = static_cast<std::size_t>(c), across = static_cast<std::size_t>(width);
        if (lut) return (*lut)[3 * (row * across + pixel) + channel];
        const std::size_t start =
            rowPeriod == 1 ? 0 : row % static_cast<std::size_t>(rowPeriod) * across;
        const std::uint32_t sum = columns[3 * (start + pixel) + channel] + rows[row];
        return grid.nodes.empty() ? sum : sum + grid.at(x, y);
    }
};

[[nodiscard]] PhaseTables phaseTables(const LinearPhase& law, int width, int height);
/// A sub-pixel's phase is the middle of its view.
[[nodiscard]] PhaseTables phaseTables(const ViewTable& table, int views, int width, int height);

} // namespace autostereo::calib
