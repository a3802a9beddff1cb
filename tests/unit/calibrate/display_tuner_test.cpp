#include "calib/solve/display_tuner.hpp"
#include "calib/solve/refusal.hpp"
#include "calib/view_map.hpp"
#include "config/load.hpp"

#include <gtest/gtest.h>

namespace autostereo::calibrate {
namespace {

class DisplayTunerTest : public testing::TestWithParam<const char*> {
  protected:
    static double value(calib::DisplayProfile display, std::size_t number) {
        const auto numbers = measuredNumbers(display);
        return *numbers.at(number).value / numbers.at(number).unit;
    }
};

TEST_P(DisplayTunerTest, EachNumberGoesUpAndDownAndBack) {
    const calib::DisplayProfile start = config::loadDisplay(GetParam());
    DisplayTuner tuner(start);
    calib::DisplayProfile copy = start;
    const auto numbers = measuredNumbers(copy);
    ASSERT_EQ(numbers.size(), 4U);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const double span = numbers[i].span / numbers[i].unit;
        EXPECT_NE(tuner.atHand().find('.' + numbers[i].key + ' '), std::string::npos);
        tuner.change(3);
        EXPECT_NEAR(value(tuner.display(), i) - value(start, i), 3 * span, 1e-9 * span);
        tuner.refine(2);
        tuner.change(-1);
        EXPECT_NEAR(value(tuner.display(), i) - value(start, i), 2.99 * span, 1e-9 * span);
        ASSERT_EQ(tuner.changed().size(), 1U);
        EXPECT_EQ(tuner.changed()[0].key, numbers[i].key);
        EXPECT_EQ(tuner.changed()[0].value, value(tuner.display(), i));
        tuner.undo();
        tuner.undo();
        EXPECT_EQ(value(tuner.display(), i), value(start, i)) << "to the last bit";
        EXPECT_TRUE(tuner.changed().empty());
        tuner.refine(-2);
        tuner.chooseNext(1);
    }
    EXPECT_NE(tuner.atHand().find('.' + numbers[0].key + ' '), std::string::npos) << "round";
    tuner.chooseNext(-1);
    EXPECT_NE(tuner.atHand().find('.' + numbers[3].key + ' '), std::string::npos);
}

TEST_P(DisplayTunerTest, UndoGoesBackThroughAllNumbers) {
    const calib::DisplayProfile start = config::loadDisplay(GetParam());
    DisplayTuner tuner(start);
    for (int i = 0; i < 40; ++i) {
        tuner.change(i % 3 - 1);
        tuner.chooseNext(i % 2 == 0 ? 1 : -2);
        tuner.refine(i % 5 - 2);
    }
    for (int i = 0; i < 50; ++i)
        tuner.undo();
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_EQ(value(tuner.display(), i), value(start, i));
}

/// What the finest step of any number does to the phase anywhere on the panel: less than the tenth
/// of a view that can be seen. From beside the shipped numbers: where lenses cover a whole number
/// of sub-pixels each the middle of what a view's sub-pixels sample lies half a sub-pixel off.
TEST_P(DisplayTunerTest, TheFinestStepIsATenthOfAView) {
    const calib::DisplayProfile start = config::loadDisplay(GetParam());
    for (int number = 0; number < 4; ++number) {
        DisplayTuner tuner(start);
        tuner.chooseNext(number);
        tuner.refine(100);
        tuner.change(1);
        const auto beside = calib::displayOptics(tuner.display())->lenses;
        tuner.change(1);
        EXPECT_EQ(tuner.changed().size(), 1U);
        const auto after = calib::displayOptics(tuner.display())->lenses;
        const glm::dvec3 eye(0, 0, start.viewingDistanceM);
        for (const double x : {-0.5, 0.0, 0.5})
            for (const double y : {-0.5, 0.0, 0.5}) {
                const glm::dvec2 place(x * start.widthM, y * start.heightM());
                const double moved = after.coordinate(eye, place) - beside.coordinate(eye, place);
                EXPECT_LT(start.views * std::abs(moved), 0.1) << tuner.atHand();
            }
    }
}

INSTANTIATE_TEST_SUITE_P(Shipped, DisplayTunerTest,
                         testing::Values("looking-glass-portrait", "slanted-8view-1080p",
                                         "cubevi-c1", "personal-varrier-30"));

TEST(DisplayTuner, WithoutOpticsIsRefused) {
    EXPECT_THROW(DisplayTuner(config::loadDisplay("preview")), Refusal);
}

} // namespace
} // namespace autostereo::calibrate
