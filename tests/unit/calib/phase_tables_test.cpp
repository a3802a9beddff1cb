// The host's phases against the formulas in extended precision, for what no shipped display has:
// every pattern of cells, every flip, phase grids.

#include "calib/panel_map.hpp"
#include "calib/phase_laws.hpp"
#include "calib/tile_view.hpp"
#include "tests/oracle/display_oracle.hpp"
#include "tests/unit/calib/cycles.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace autostereo::calib {
namespace {

LookingGlassCalibration unitWithCells(CellPattern pattern) {
    LookingGlassCalibration unit;
    unit.pitch = 44.72;
    unit.slope = -6.9;
    unit.center = 0.3;
    unit.dpi = 283;
    unit.screenWidth = 101;
    unit.screenHeight = 67;
    unit.pattern = pattern;
    for (int cell = 0; cell < cellCount(pattern); ++cell)
        unit.cells.push_back({{{-0.31 + 0.05 * cell, 0.25}, {0.28, -0.1 * cell}, {0.07, 0.2}}});
    return unit;
}

void expectFormula(const LookingGlassCalibration& unit) {
    const PhaseTables tables =
        phaseTables(*affinePhase(unit, 48), unit.screenWidth, unit.screenHeight);
    const oracle::LookingGlass formula(unit);
    Real worst = 0;
    for (int y = 0; y < unit.screenHeight; ++y)
        for (int x = 0; x < unit.screenWidth; ++x)
            for (int c = 0; c < 3; ++c)
                worst =
                    std::max(worst, apart(std::ldexp(static_cast<Real>(tables.phase(x, y, c)), -32),
                                          formula(x, y, c)));
    // Two roundings to 2^-32, and 2^-49 for each of 168 columns and rows.
    EXPECT_LE(worst, std::ldexp(Real{1}, -32) + std::ldexp(Real{1}, -41));
}

TEST(PhaseTables, CellsOfEveryPattern) {
    for (const auto pattern : {CellPattern::Single, CellPattern::Checkerboard, CellPattern::Columns,
                               CellPattern::Staircase, CellPattern::Rows, CellPattern::FourRows}) {
        SCOPED_TRACE(static_cast<int>(pattern));
        expectFormula(unitWithCells(pattern));
    }
}

TEST(PhaseTables, EveryFlip) {
    for (unsigned flips = 0; flips < 8; ++flips) {
        SCOPED_TRACE(flips);
        auto unit = unitWithCells(CellPattern::Single);
        unit.cells.clear();
        unit.flipImageX = (flips & 1U) != 0;
        unit.flipImageY = (flips & 2U) != 0;
        unit.flipSubpixels = (flips & 4U) != 0;
        expectFormula(unit);
    }
}

TEST(PhaseTables, BgrTurnsTheStripe) {
    const auto phases = [](bool bgr) {
        return phaseTables(vanBerkelPhase({8.3, 1.1, 0.2, bgr}, 8), 20, 20);
    };
    for (int x = 0; x < 20; ++x)
        for (int c = 0; c < 3; ++c)
            EXPECT_EQ(phases(true).phase(x, 3, c), phases(false).phase(x, 3, 2 - c));
}

TEST(PhaseTables, GridIsBilinearFromCornerToCorner) {
    constexpr int kWidth = 97, kHeight = 61, kColumns = 5, kRows = 4;
    LinearPhase law;
    law.grid.columns = kColumns;
    law.grid.rows = kRows;
    for (int node = 0; node < kColumns * kRows; ++node)
        law.grid.cycles.push_back(0.2 * std::sin(1.3 * node));
    const PhaseTables tables = phaseTables(law, kWidth, kHeight);
    const auto node = [&](int column, int row) {
        const auto at = static_cast<std::size_t>(std::min(row, kRows - 1)) * kColumns +
                        static_cast<std::size_t>(std::min(column, kColumns - 1));
        return static_cast<Real>(law.grid.cycles.at(at));
    };
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const Real u = static_cast<Real>(x) * (kColumns - 1) / (kWidth - 1);
            const Real v = static_cast<Real>(y) * (kRows - 1) / (kHeight - 1);
            const int column = static_cast<int>(u), row = static_cast<int>(v);
            const Real s = u - column, t = v - row;
            const Real exact =
                (1 - t) * ((1 - s) * node(column, row) + s * node(column + 1, row)) +
                t * ((1 - s) * node(column, row + 1) + s * node(column + 1, row + 1));
            // Floors of three interpolations and roundings of nodes: below 4 units of 2^-32.
            EXPECT_LE(apart(std::ldexp(static_cast<Real>(tables.phase(x, y, 1)), -32), exact),
                      std::ldexp(Real{1}, -30))
                << x << ' ' << y;
        }
}

TEST(PhaseTables, EveryLensLawKeepsItsGrid) {
    const PhaseGrid grid{2, 2, {0.1, 0.2, 0.3, 0.4}};
    auto glass = unitWithCells(CellPattern::Single);
    glass.grid = grid;
    LinearPhase linear;
    linear.grid = grid;
    for (const DisplayLaw& law :
         {DisplayLaw{linear}, DisplayLaw{VanBerkelLens{8.3, 1.1, 0.2, false, grid}},
          DisplayLaw{glass}, DisplayLaw{CubeviCalibration{19.6, 0.1, 0, grid}}}) {
        auto with = affinePhase(law, 8).value();
        const PhaseTables bent = phaseTables(with, 97, 61);
        with.grid = {};
        const PhaseTables flat = phaseTables(with, 97, 61);
        const auto corner = [&](int x, int y) {
            return std::ldexp(static_cast<Real>(bent.phase(x, y, 1) - flat.phase(x, y, 1)), -32);
        };
        EXPECT_NEAR(static_cast<double>(corner(0, 0)), 0.1, 1e-8) << law.index();
        EXPECT_NEAR(static_cast<double>(corner(96, 0)), 0.2, 1e-8) << law.index();
        EXPECT_NEAR(static_cast<double>(corner(0, 60)), 0.3, 1e-8) << law.index();
    }
}

/// Half frames count from the top, quilts from the bottom; the rest of 7 / 2 and 7 / 3 stays empty.
TEST(TileView, LiesAsItsKindSays) {
    const TileFrame halves{2, 1, true, false}, turned{2, 1, true, true}, above{1, 2, true, false};
    EXPECT_EQ(tileView(halves, 2, 7, 6, 0, 0), 0);
    EXPECT_EQ(tileView(halves, 2, 7, 6, 3, 5), 1);
    EXPECT_EQ(tileView(halves, 2, 7, 6, 6, 0), -1);
    EXPECT_EQ(tileView(turned, 2, 7, 6, 0, 0), 1);
    EXPECT_EQ(tileView(above, 2, 7, 6, 0, 0), 0);
    EXPECT_EQ(tileView(above, 2, 7, 6, 0, 5), 1);
    const TileFrame quilt{2, 3, false, false};
    EXPECT_EQ(tileView(quilt, 6, 7, 7, 0, 6), 0) << "bottom left";
    EXPECT_EQ(tileView(quilt, 6, 7, 7, 5, 6), 1);
    EXPECT_EQ(tileView(quilt, 6, 7, 7, 0, 1), 4);
    EXPECT_EQ(tileView(quilt, 6, 7, 7, 0, 0), -1);
    EXPECT_EQ(tileView(quilt, 5, 7, 7, 5, 1), -1) << "a tile without a view";
}

} // namespace
} // namespace autostereo::calib
