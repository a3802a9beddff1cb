#include "calib/phase_tables.hpp"

#include <algorithm>
#include <cmath>

namespace autostereo::calib {

namespace {

/// Cycles -> 2^-48 cycles, wrapping.
std::uint64_t fixed48(long double cycles) {
    return static_cast<std::uint64_t>(std::llround(std::ldexp(cycles - std::floor(cycles), 48)));
}

/// a + (b - a) weight / 2^31, on the circle, the shorter way round; floor.
std::uint32_t between(std::uint32_t a, std::uint32_t b, std::uint32_t weight) {
    const std::int64_t product =
        static_cast<std::int64_t>(static_cast<std::int32_t>(b - a)) * weight;
    return a + static_cast<std::uint32_t>(product >> 31);
}

/// Pixels' places among nodes that span them from the first centre to the last.
std::vector<GridTables::Place> places(int pixels, int nodes) {
    std::vector<GridTables::Place> places;
    places.reserve(static_cast<std::size_t>(pixels));
    for (int pixel = 0; pixel < pixels; ++pixel) {
        const long double at =
            pixels > 1 ? static_cast<long double>(pixel) * (nodes - 1) / (pixels - 1) : 0;
        const auto node = std::min(static_cast<std::uint32_t>(at),
                                   static_cast<std::uint32_t>(std::max(0, nodes - 2)));
        const long double weight = std::min(at - node, 1.0L);
        places.push_back({node, std::min(static_cast<std::uint32_t>(std::ldexp(weight, 31)),
                                         std::uint32_t{0x7fffffff})});
    }
    return places;
}

GridTables gridTables(const PhaseGrid& grid, int width, int height) {
    GridTables tables;
    if (grid.cycles.empty()) return tables;
    tables.columns = grid.columns;
    tables.rows = grid.rows;
    for (const double cycles : grid.cycles)
        tables.nodes.push_back(turns(cycles));
    tables.columnPlaces = places(width, grid.columns);
    tables.rowPlaces = places(height, grid.rows);
    return tables;
}

} // namespace

std::uint32_t turns(long double cycles) {
    const long double fraction = cycles - std::floor(cycles);
    return static_cast<std::uint32_t>(
        static_cast<std::uint64_t>(std::llround(std::ldexp(fraction, 32))));
}

std::uint32_t GridTables::at(int x, int y) const {
    const Place across = columnPlaces[static_cast<std::size_t>(x)];
    const Place down = rowPlaces[static_cast<std::size_t>(y)];
    const std::uint32_t nextColumn = columns > 1 ? 1 : 0;
    const std::size_t upper = down.node * static_cast<std::size_t>(columns) + across.node;
    const std::size_t lower = upper + (rows > 1 ? static_cast<std::size_t>(columns) : 0);
    return between(between(nodes[upper], nodes[upper + nextColumn], across.weight),
                   between(nodes[lower], nodes[lower + nextColumn], across.weight), down.weight);
}

PhaseTables phaseTables(const LinearPhase& law, int width, int height) {
    PhaseTables tables(width, height);
    tables.affine.perColumn = fixed48(law.perColumn);
    tables.affine.perRow = fixed48(law.perRow);
    for (int cell = 0; cell < AffinePhase::kCells; ++cell) {
        const int yUp = 4 * height + height - 1 - cell / 2; // patterns repeat every 4 rows
        const auto& channels =
            law.channels[static_cast<std::size_t>(cellOf(law.pattern, cell % 2, yUp))];
        for (std::size_t c = 0; c < channels.size(); ++c)
            tables.affine.channels[static_cast<std::size_t>(cell)][c] =
                turns(static_cast<long double>(channels[c]) + law.offset);
    }
    tables.grid = gridTables(law.grid, width, height);
    return tables;
}

PhaseTables phaseTables(const ViewTable& table, int views, int width, int height) {
    PhaseTables tables(width, height);
    tables.pattern.rows = static_cast<int>(table.rows.size());
    for (const std::vector<int>& row : table.rows)
        for (std::size_t k = 0; k < 3 * static_cast<std::size_t>(width); ++k)
            tables.pattern.phases.push_back(turns((row[k % row.size()] + 0.5L) / views));
    return tables;
}

} // namespace autostereo::calib
