#include "calib/solve/view_gate.hpp"

#include <glm/vec2.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace autostereo::calibrate {
namespace {

using Verdict = ViewGate::Verdict;

const Board kBoard{9, 6, 0.025, {}};
constexpr int kWidth = 640, kHeight = 480;

/// A board whose middle is at (x, y), its squares so many pixels wide; `lean`: the top's width over
/// the bottom's.
BoardView seen(double x, double y, double square = 20, double lean = 1) {
    BoardView view;
    for (int id = 0; id < kBoard.corners(); ++id) {
        const int fromTop = id / kBoard.columns;
        const double column = id % kBoard.columns - 4, row = fromTop - 2.5;
        const double wide = square * std::pow(lean, -row / 5);
        view.ids.push_back(id);
        view.pixels.emplace_back(x + wide * column, y + square * row);
    }
    return view;
}

class ViewGateTest : public testing::Test {
  protected:
    Verdict held(const BoardView& view, double edge = 1.5) {
        static_cast<void>(next(view, edge));
        return next(view, edge);
    }
    Verdict next(const BoardView& view, double edge = 1.5) {
        timeS += 0.1;
        return gate.judge(view, timeS, edge);
    }
    double timeS = 1e5;
    ViewGate gate{kBoard, kWidth, kHeight};
};

TEST_F(ViewGateTest, WaitsUntilTheBoardIsStill) {
    EXPECT_EQ(next(seen(320, 240)), Verdict::Moving) << "nobody knows yet";
    EXPECT_EQ(next(seen(324, 240)), Verdict::Moving);
    EXPECT_EQ(next(seen(326, 240)), Verdict::Take) << "2 pixels of 640 in 0.1 s";
}

TEST_F(ViewGateTest, WaitsUntilItIsSharp) {
    EXPECT_EQ(held(seen(320, 240), 6), Verdict::Blurred);
    EXPECT_EQ(next(seen(320, 240), 2), Verdict::Take);
}

TEST_F(ViewGateTest, TakesOnlyWhatIsNew) {
    EXPECT_EQ(held(seen(320, 240)), Verdict::Take);
    EXPECT_EQ(held(seen(320, 240)), Verdict::SeenBefore);
    EXPECT_EQ(held(seen(340, 240)), Verdict::SeenBefore) << "a thirtieth of the picture further";
    EXPECT_EQ(held(seen(420, 240)), Verdict::Take) << "elsewhere";
    EXPECT_EQ(held(seen(320, 240, 30)), Verdict::Take) << "nearer";
    EXPECT_EQ(held(seen(320, 240, 20, 1.2)), Verdict::Take) << "tilted";
    EXPECT_EQ(held(seen(320, 240, 20, 1.21)), Verdict::SeenBefore);
}

TEST_F(ViewGateTest, SaysWhatIsMissingUntilNothingIs) {
    EXPECT_EQ(gate.wanted(), "to the picture's upper left");
    EXPECT_EQ(held(seen(320, 240)), Verdict::Take);
    EXPECT_EQ(gate.wanted(), "tilt the board");
    int views = 0;
    for (const double y : {80.0, 240.0, 400.0})
        for (const double x : {110.0, 320.0, 530.0})
            views += held(seen(x, y, 20, 1.3)) == Verdict::Take ? 1 : 0;
    EXPECT_EQ(views, 9);
    EXPECT_EQ(gate.covered(), 1);
    EXPECT_EQ(gate.wanted(), std::nullopt);
}

/// Parts of a ChArUco board: what is seen counts.
TEST_F(ViewGateTest, PartsOfABoardAreViews) {
    BoardView part = seen(320, 240);
    std::erase_if(part.ids, [](int id) { return id % 9 > 5; });
    const BoardView whole = seen(320, 240);
    part.pixels.clear();
    for (const int id : part.ids)
        part.pixels.push_back(whole.pixels[static_cast<std::size_t>(id)]);
    EXPECT_EQ(held(part), Verdict::Take);
    part.ids.resize(3);
    part.pixels.resize(3);
    EXPECT_EQ(held(part), Verdict::SeenBefore) << "three corners tell nothing";
}

/// Squares under a blur of known width.
TEST(EdgeWidth, GrowsWithTheBlur) {
    for (const double wide : {1.0, 3.0, 8.0}) {
        std::vector<std::uint16_t> values;
        const BoardView view = seen(320, 240, 40);
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                // Products of two waves that are 1 and -1 with ramps `wide` pixels wide in between.
                const auto wave = [&](double at) {
                    const double phase = at / 40 - std::floor(at / 40);
                    const double off = 40 * (phase < 0.5 ? phase : phase - 1);
                    const double sign =
                        static_cast<long>(std::floor(at / 40 + 0.5)) % 2 == 0 ? 1 : -1;
                    return sign * std::clamp(2 * off / wide, -1.0, 1.0);
                };
                const double level = wave(x - view.pixels[0].x) * wave(y - view.pixels[0].y);
                values.push_back(static_cast<std::uint16_t>(std::lround(120 + 80 * level)));
            }
        const double found = edgeWidth({kWidth, kHeight, values, false}, view, kBoard);
        // A ramp narrower than two pixels has the slope of two: central differences.
        EXPECT_NEAR(found, std::max(wide, 2.0), 0.15 * std::max(wide, 2.0)) << wide;
    }
}

} // namespace
} // namespace autostereo::calibrate
