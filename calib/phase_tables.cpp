#include "calib/phase_tables.hpp"

#include <algorithm>
#include <cmath>

namespace autostereo::calib {

namespace {

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
    tables.rowPeriod = cellOf(law.pattern, 0, 1) != 0 ? cellCount(law.pattern) : 1;
    tables.columns.reserve(3 * static_cast<std::size_t>(tables.rowPeriod) *
                           static_cast<std::size_t>(width));
    for (int row = 0; row < tables.rowPeriod; ++row) {
        const int yUp = (4 * height + height - 1 - row) % 4; // patterns repeat every 4 rows
        for (int x = 0; x < width; ++x) {
            const auto cell = static_cast<std::size_t>(cellOf(law.pattern, x, yUp));
            for (const double channel : law.channels[cell])
                tables.columns.push_back(
                    turns(static_cast<long double>(law.perColumn) * x + channel));
        }
    }
    tables.rows.reserve(static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y)
        tables.rows.push_back(turns(static_cast<long double>(law.perRow) * y + law.offset));
    tables.grid = gridTables(law.grid, width, height);
    return tables;
}

PhaseTables phaseTables(const ViewTable& table, int views, int width, int height) {
    PhaseTables tables(width, height);
    tables.rowPeriod = static_cast<int>(table.rows.size());
    for (const std::vector<int>& row : table.rows)
        for (std::size_t k = 0; k < 3 * static_cast<std::size_t>(width); ++k)
            tables.columns.push_back(turns((row[k % row.size()] + 0.5L) / views));
    tables.rows.assign(static_cast<std::size_t>(height), 0);
    return tables;
}

} // namespace autostereo::calib
