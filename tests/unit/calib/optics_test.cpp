#include "calib/band_map.hpp"
#include "calib/optics.hpp"
#include "tests/unit/calib/shown_display.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace autostereo::calib {
namespace {

DisplayProfile lensDisplay(int views, const DisplayLaw& law) {
    DisplayProfile display;
    display.width = 480;
    display.height = 320;
    display.widthM = 0.1;
    display.viewingDistanceM = 0.6;
    display.coneRad = 0.6;
    display.views = views;
    display.law = law;
    display.optics.kind = Optics::Kind::Lens;
    return display;
}

LookingGlassCalibration unit() {
    LookingGlassCalibration unit;
    unit.pitch = 44.72;
    unit.slope = -7.45;
    unit.center = 0.2;
    unit.dpi = 480 / (0.1 / 0.0254);
    unit.screenWidth = 480;
    unit.screenHeight = 320;
    return unit;
}

void expectDirections(const DisplayProfile& display, double slack = 0) {
    const auto shown = shownDisplay(display);
    ASSERT_TRUE(shown);
    for (const glm::dvec3& eye :
         {glm::dvec3{0, 0, 0.6}, glm::dvec3{0.1, 0.15, 0.6}, glm::dvec3{-0.05, -0.2, 0.6},
          glm::dvec3{0.02, 0.1, 0.45}, glm::dvec3{-0.1, 0.03, 0.9}})
        EXPECT_LE(shown->worstAt(eye), shown->mostAt() + slack)
            << eye.x << ' ' << eye.y << ' ' << eye.z;
}

TEST(Optics, LookingGlassOfAllGenerations) {
    expectDirections(lensDisplay(49, unit()));
    for (int flip = 0; flip < 3; ++flip) {
        auto flipped = unit();
        (flip == 0   ? flipped.flipImageX
         : flip == 1 ? flipped.flipImageY
                     : flipped.flipSubpixels) = true;
        SCOPED_TRACE(flip);
        expectDirections(lensDisplay(49, flipped));
    }
    const std::vector<SubpixelCell> cells{{{{-0.25, -0.31}, {-0.25, 0.28}, {0.25, 0}}},
                                          {{{0.25, -0.31}, {0.25, 0.28}, {-0.25, 0}}}};
    for (const CellPattern pattern :
         {CellPattern::Rows, CellPattern::Columns, CellPattern::Checkerboard}) {
        auto third = unit();
        third.cells = cells;
        third.pattern = pattern;
        expectDirections(lensDisplay(49, third));
    }
}

TEST(Optics, CubeviAndVanBerkel) {
    for (const CubeviCalibration& cubevi :
         {CubeviCalibration{19.6138, -0.1007, -1.95}, CubeviCalibration{19.625, 0.1057, 8.89}}) {
        auto display = lensDisplay(40, cubevi);
        display.order = ViewOrder::RightToLeft; // its phase rises to the right
        expectDirections(display);
    }
    for (const bool bgr : {false, true}) {
        auto slanted = lensDisplay(9, VanBerkelLens{4.5, 0.5, 1.5, bgr});
        slanted.order = ViewOrder::RightToLeft;
        expectDirections(slanted);
    }
}

TEST(Optics, LinearPhaseWithCellsAndLocalCorrection) {
    LinearPhase law;
    law.perColumn = -0.171;
    law.perRow = 0.021;
    law.offset = 0.37;
    law.pattern = CellPattern::Checkerboard;
    law.channels = {{0.01, -0.05, -0.1}, {0.02, -0.06, -0.11}};
    expectDirections(lensDisplay(30, law));
    // The law corrects at the sub-pixel, an eye aside looks through a lens half a lens away: there
    // the correction differs by 0.2 cycle over 240 pixels times three.
    constexpr double kSlack = 2 * 0.2 / 240 * 3;
    law.grid = {3, 2, {0.9, -0.9, 0, 0, 0.15, 0.02}}; // 0.9 to -0.9 is the shorter way 0.2
    expectDirections(lensDisplay(30, law), kSlack);
    law.perColumn = 0.171; // phase that rises to the right: views from the right
    law.channels = {{-0.01, 0.05, 0.1}, {-0.02, 0.06, 0.11}};
    auto reversed = lensDisplay(30, law);
    reversed.order = ViewOrder::RightToLeft;
    expectDirections(reversed, kSlack);
}

/// A grid's nodes go with the law: along its phase, from its row 0.
TEST(Optics, LocalCorrectionOfEveryFamily) {
    const PhaseGrid grid{3, 2, {0.1, -0.1, 0, 0, 0.15, 0.02}};
    constexpr double kSlack = 2 * 0.2 / 240 * 3; // as above
    for (const bool flipped : {false, true}) {
        auto glass = unit();
        glass.flipImageY = flipped;
        glass.grid = grid;
        expectDirections(lensDisplay(49, glass), kSlack);
    }
    for (const DisplayLaw& law : {DisplayLaw{CubeviCalibration{19.6138, -0.1007, -1.95, grid}},
                                  DisplayLaw{VanBerkelLens{9.03, 1.1, 0.2, false, grid}}}) {
        auto display = lensDisplay(40, law);
        display.order = ViewOrder::RightToLeft;
        expectDirections(display, kSlack);
    }
}

TEST(Optics, LocalCorrectionOfALineScreen) {
    LineScreen screen;
    screen.linesPerM = 270 * 3;
    screen.dutyCycle = 0.75;
    screen.thicknessM = 0.004;
    screen.angleRad = 0.15;
    auto display = lensDisplay(2, screen);
    const auto flat = displayOptics(display).value().lenses;
    screen.grid = {2, 2, {0.1, 0.3, -0.1, 0.1}};
    display.law = screen;
    const auto bent = displayOptics(display).value().lenses;
    const glm::dvec3 eye{0, 0, 0.6};
    for (const glm::dvec2& place : {glm::dvec2{0, 0}, {-0.04, 0.02}, {0.03, -0.03}}) {
        // Linear between the outermost pixels' centres.
        const double expected =
            0.1 + 0.2 * place.x / (0.1 * 479 / 480) + 0.2 * place.y / (0.1 * 319 / 480);
        EXPECT_NEAR(bent.coordinate(eye, place) - flat.coordinate(eye, place), expected, 1e-12);
    }
    const LinearPhase phase = lineScreenPhase(screen, display, 480, 320, eye);
    EXPECT_EQ(phase.grid.cycles, screen.grid.cycles);
}

/// A gap that the file gives counts, not the fan: half of it, and the fan is twice as wide.
TEST(Optics, AGivenGapReplacesTheFans) {
    auto display = lensDisplay(9, VanBerkelLens{9, 1, 0});
    const double pixel = display.widthM / display.width, period = 3 * pixel;
    const auto fanned = displayOptics(display).value().lenses;
    EXPECT_NEAR(fanned.gapM, fanned.pitchM / (2 * std::tan(0.3)), 1e-15);
    EXPECT_NEAR(fanned.pitchM, period * (1 - fanned.gapM / 0.6), 1e-15);
    display.optics.gapM = fanned.gapM / 2;
    display.optics.aperture = 0.3;
    const auto given = displayOptics(display).value().lenses;
    EXPECT_EQ(given.gapM, fanned.gapM / 2);
    EXPECT_NEAR(given.pitchM, period * (1 - given.gapM / 0.6), 1e-15);
    EXPECT_EQ(given.aperture, 0.3);
}

TEST(Optics, TablesNeedAGapAndRegularSteps) {
    auto display = lensDisplay(
        6, ViewTable{{{0, 2, 4}, {5, 1, 3}, {4, 0, 2}, {3, 5, 1}, {2, 4, 0}, {1, 3, 5}}});
    EXPECT_FALSE(displayOptics(display));
    display.optics.gapM = 0.0004;
    const auto lenses = displayOptics(display).value().lenses;
    EXPECT_NEAR(lenses.pitchM, 0.1 / 480 * (1 - 0.0004 / 0.6), 1e-15) << "three sub-pixels";
    EXPECT_NEAR(lenses.slant, -1.0 / 6, 1e-15);
    for (const ViewTable& irregular :
         {ViewTable{{{0, 1, 3}}}, ViewTable{{{0, 0, 0}}}, ViewTable{{{0, 1, 2, 3, 4}}},
          ViewTable{{{0, 1, 2, 3, 4, 5}, {0, 1, 2, 3, 5, 4}}}}) {
        display.law = irregular;
        EXPECT_FALSE(displayOptics(display));
    }
}

TEST(Optics, FormatsWithoutGlassHaveNone) {
    for (const DisplayLaw& law : {DisplayLaw{TileFrame{}}, DisplayLaw{DepthFrame{}},
                                  DisplayLaw{ViewLut{}}, DisplayLaw{ViewTable{{{0, 1, 1}}}}})
        EXPECT_FALSE(displayOptics(lensDisplay(2, law)));
    auto none = lensDisplay(9, VanBerkelLens{9, 1, 0});
    none.optics.kind = Optics::Kind::None;
    EXPECT_FALSE(displayOptics(none));
}

/// Eyes at the height of the panel's middle and its nominal distance: there the law's numbers are
/// defined, and each eye sees the middle of the band that is lit for it.
TEST(Optics, TrackedLensShowsAnEyeItsBand) {
    TrackedLens lens;
    lens.periodPx = 5.32;
    lens.rowIncrementPx = 0.183528;
    lens.initPx = 1.3;
    lens.fill = 0.2;
    lens.eyeGainPx = -6.1;
    lens.zBiasM = -0.0013;
    const auto display = lensDisplay(2, lens);
    const auto optics = displayOptics(display).value();
    EXPECT_GT(optics.lenses.gapM, 0);
    const double seenWidth = 1 / (3 * lens.periodPx); // of a sub-pixel
    for (const double x : {-0.2, -0.07, 0.0, 0.03, 0.1}) {
        // Lines lean by the row increment: an eye that moves along one sees the same.
        const glm::dvec3 eye{x, 1.5 * x - 0.05, display.viewingDistanceM};
        const LinearPhase phase = trackedLensPhase(lens, eye);
        double worst = 0;
        forSeen(optics, {}, eye, spreadRows(display.height, 20), [&](const SeenSubpixel& seen) {
            const double cycles = phase.perColumn * seen.x + phase.perRow * seen.y + phase.offset +
                                  phase.channels[0].at(static_cast<std::size_t>(seen.c));
            const double beside = cycles - lens.fill / 2;
            worst = std::max(worst, std::abs(beside - std::round(beside)));
        });
        EXPECT_LE(worst, seenWidth / 2 + 1e-6) << x;
    }
}

} // namespace
} // namespace autostereo::calib
