// A panel's optics from simulated photographs, on a small panel; full-size ones are in
// tests/stress/calibrate.

#include "calib/solve/refusal.hpp"
#include "tests/unit/calibrate/simulated_panels.hpp"

#include <gtest/gtest.h>

namespace autostereo::calibrate {
namespace {

/// 640x400 pixels of half a millimetre, eight views, lenses of 7.6 sub-pixels.
calib::DisplayProfile smallPanel() {
    calib::DisplayProfile panel = config::loadDisplay("slanted-8view-1080p");
    panel.width = 640;
    panel.height = 400;
    panel.widthM = 0.32;
    panel.viewingDistanceM = 0.7;
    panel.coneRad = 0.5;
    panel.law = calib::VanBerkelLens{7.6, 0.9, 0.3, false};
    return panel;
}

class DisplaySolverTest : public testing::Test {
  protected:
    [[nodiscard]] std::vector<PanelSight> sights(const calib::DisplayProfile& truth,
                                                 const calib::DisplayProfile& assumed) {
        return sightsOf(truth, assumed, placesFor(assumed, camera), camera);
    }
    /// Why photographs of `truth` are refused where `assumed` is named; empty: they are not.
    std::string refusal(const calib::DisplayProfile& truth, const calib::DisplayProfile& assumed) {
        try {
            static_cast<void>(calibrateDisplay(assumed, sights(truth, assumed)));
            return {};
        } catch (const Refusal& why) {
            // The board is the same whatever the lenses are thought to be.
            EXPECT_EQ(std::string(why.what()).find("chessboard"), std::string::npos) << why.what();
            return why.what();
        }
    }
    test::PanelCamera camera{720, 540, 3};
};

TEST_F(DisplaySolverTest, FindsAUnitsNumbers) {
    const auto model = smallPanel();
    const auto unit = unitOf(model, 5, 1);
    ASSERT_GT(phaseErrorViews(model, unit, 0.99), 2); // it does not fit as it is
    const DisplayCalibration found = calibrateDisplay(model, sights(unit, model));
    EXPECT_LT(phaseErrorViews(found.display, unit, 0.99), 0.1);
    EXPECT_LT(found.half95Views, 0.5);
    EXPECT_TRUE(calib::phaseGrid(found.display.law)->cycles.empty()) << "its sheet is flat";
    ASSERT_EQ(found.numbers.size(), 4U);
    auto truth = unit;
    const auto numbers = measuredNumbers(truth);
    for (const std::size_t i : {0U, 1U, 3U}) // the offset is known up to whole lenses only
        EXPECT_NEAR(found.numbers[i].value, *numbers[i].value / numbers[i].unit,
                    3 * found.numbers[i].half95) // 95 % of one run each, systematic parts beside
            << found.numbers[i].key;
}

TEST_F(DisplaySolverTest, ABentSheetGetsAGrid) {
    const auto model = smallPanel();
    const auto unit = bent(unitOf(model, 5, 1), 0.1);
    DisplayCalibration found = calibrateDisplay(model, sights(unit, model));
    EXPECT_LT(phaseErrorViews(found.display, unit, 0.99), 0.1);
    EXPECT_LT(phaseErrorViews(found.display, unit, 0.95), found.half95Views);
    EXPECT_GT(found.deformationViews, 0.15);
    EXPECT_LT(found.localViews, 0.1);
    // Measured again, as a display that has that grid, it is not taken twice; flat again, it goes.
    const auto again = calibrateDisplay(found.display, sights(unit, found.display));
    EXPECT_LT(phaseErrorViews(again.display, unit, 0.99), 0.1);
    const auto flat = calibrateDisplay(found.display, sights(unitOf(model, 5, 1), found.display));
    EXPECT_TRUE(calib::phaseGrid(flat.display.law)->cycles.empty());
    calib::phaseGrid(found.display.law)->cycles.clear();
    EXPECT_GT(phaseErrorViews(found.display, unit, 0.99), 0.3) << "nothing to correct";
}

/// What differs from place to place is no sheet's: a grid from one place would be wrong in others.
TEST_F(DisplaySolverTest, WhatMovesWithTheCameraMakesNoGrid) {
    const auto model = smallPanel();
    auto seen = sights(model, model);
    for (std::size_t sight = 0; sight < seen.size(); ++sight)
        for (std::size_t block = 0; block < seen[sight].fringes.residual.size(); ++block)
            seen[sight].fringes.residual[block] =
                0.03 * std::sin(0.9 * static_cast<double>(block) +
                                2.1 * static_cast<double>(sight)); // a third of a turn each
    const auto found = calibrateDisplay(model, seen);
    EXPECT_TRUE(calib::phaseGrid(found.display.law)->cycles.empty());
    EXPECT_GT(found.localViews, 0.1) << "it is said";
}

TEST_F(DisplaySolverTest, ASecondRoundStartsFromTheFirst) {
    const auto model = smallPanel();
    const auto unit = unitOf(model, 6, 1);
    const DisplayCalibration first = calibrateDisplay(model, sights(unit, model));
    const DisplayCalibration second = calibrateDisplay(first.display, sights(unit, first.display));
    EXPECT_LT(phaseErrorViews(second.display, unit, 0.99), 0.1);
}

TEST_F(DisplaySolverTest, AnotherModelIsRefused) {
    const auto truth = smallPanel();
    const auto with = [&](double period, double shift, double cone) {
        auto other = truth;
        other.law = calib::VanBerkelLens{period, shift, 0, false};
        other.coneRad = cone;
        return other;
    };
    // Twice as many lenses make the same fringes from one place, half as many none.
    EXPECT_NE(refusal(truth, with(3.8, 0.9, 0.5)), "");
    EXPECT_NE(refusal(truth, with(15.2, 0.9, 0.5)), "");
    EXPECT_NE(refusal(truth, with(7.3, 0.9, 0.5)), "");  // 4 % off
    EXPECT_NE(refusal(truth, with(7.6, -0.9, 0.5)), ""); // leaning the other way
}

TEST_F(DisplaySolverTest, OnePlaceIsNotEnough) {
    const auto model = smallPanel();
    auto one = sights(model, model);
    one.resize(1);
    EXPECT_THROW(static_cast<void>(calibrateDisplay(model, one)), Refusal);
    const std::vector<PanelSight> twice{one[0], one[0]};
    EXPECT_THROW(static_cast<void>(calibrateDisplay(model, twice)), Refusal);
}

TEST_F(DisplaySolverTest, AMovedCameraIsNoticed) {
    const auto model = smallPanel();
    auto seen = sights(model, model);
    seen[1].eye.x += 0.02; // of 0.35 m
    EXPECT_THROW(static_cast<void>(calibrateDisplay(model, seen)), Refusal);
}

TEST_F(DisplaySolverTest, PicturesWithoutAPanelAreRefused) {
    const auto model = smallPanel();
    const calib::SubpixelLayout panel = *calib::subpixelLayout(model);
    const std::vector<std::uint8_t> grey(3U * 720 * 540, 128);
    const ColorImage image{720, 540, grey};
    EXPECT_THROW(
        static_cast<void>(seePanel(panel, camera.model(), {"grey", image, {image, image, image}})),
        Refusal);
    const ColorImage other{540, 720, grey};
    EXPECT_THROW(
        static_cast<void>(seePanel(panel, camera.model(), {"size", other, {image, image, image}})),
        Refusal);
}

} // namespace
} // namespace autostereo::calibrate
