#include "devices/input.hpp"
#include "devices/sim/calibration_board.hpp"
#include "devices/sim/hash.hpp"
#include "devices/sim/person.hpp"
#include "devices/sim/room.hpp"
#include "devices/sim/simulation.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace autostereo::devices::sim {
namespace {

constexpr double kExact = 1e-12; // rounding of a few products

TEST(RoomScene, WallsAreWhereTheyShouldBe) {
    const auto scene = makeScene("room", 1);
    // Directions that meet no furniture.
    EXPECT_NEAR(scene->trace({0, 0, 0}, {0.08, 0.02, 1.0}, 0).point.z, kBackWallZ, kExact);
    EXPECT_NEAR(scene->trace({0, 0, 0}, {0.08, 0.02, 1.0}, 0).distance, kBackWallZ, kExact);
    EXPECT_NEAR(scene->trace({0, 0, 0}, {-1, 0, 0}, 0).distance, kSideWallX, kExact);
    EXPECT_NEAR(scene->trace({0, 0, 0}, {1, 0, 0}, 0).distance, kSideWallX, kExact);
    EXPECT_NEAR(scene->trace({0, 0, 0}, {0, -1, 0}, 0).distance, -kCeilingY, kExact);
    EXPECT_NEAR(scene->trace({0, 0, 0}, {0, 0, -1}, 0).distance, -kFrontWallZ, kExact);
    EXPECT_NEAR(scene->trace({0, 0, 0}, {0, 1, 0}, 0).distance, kFloorY, 0.01); // boards, rug
}

TEST(RoomScene, HasObjectsFromOneMetreOn) {
    const auto scene = makeScene("room", 1);
    const Hit ball = scene->trace({0, 0, 0}, {0.50, 0.325, 1.10}, 0); // towards its middle
    EXPECT_NEAR(ball.rangeM, glm::length(glm::dvec3(0.50, 0.325, 1.10)) - 0.075, kExact);
    EXPECT_NEAR(ball.cosine, 1.0, kExact);
    EXPECT_GT(ball.color.r, 2 * ball.color.b); // red
}

TEST(RoomScene, SeedChangesTexturesOnly) {
    const auto one = makeScene("room", 1), two = makeScene("room", 2);
    int different = 0;
    for (int i = -20; i <= 20; ++i) {
        const glm::dvec3 direction{0.04 * i, 0.02, 1};
        const Hit a = one->trace({0, 0, 0}, direction, 0), b = two->trace({0, 0, 0}, direction, 0);
        EXPECT_EQ(a.distance, b.distance);
        different += a.color == b.color ? 0 : 1;
    }
    EXPECT_GT(different, 20);
}

class EveryScene : public ::testing::TestWithParam<const char*> {};

TEST_P(EveryScene, AnswersEveryRay) {
    const auto scene = makeScene(GetParam(), 1);
    const Snapshot now = scene->at(1.7);
    for (std::uint64_t i = 0; i < 4000; ++i) {
        const auto value = [&](std::uint64_t which) {
            return 2 * uniformFrom(hashBits(9, 5 * i + which)) - 1;
        };
        const Hit hit =
            now.trace({{0.2 * value(3), 0.2 * value(4), 0}, {value(0), value(1), value(2)}});
        ASSERT_LT(hit.rangeM, 6.0);
        ASSERT_GT(hit.rangeM, 0.3);
        for (int channel = 0; channel < 3; ++channel) {
            ASSERT_GE(hit.color[channel], 0);
            ASSERT_LE(hit.color[channel], 255);
        }
        ASSERT_GE(hit.cosine, 0);
        ASSERT_LE(hit.cosine, 1);
        ASSERT_GT(hit.irReflectance, 0);
    }
}

// A point looks the same from everywhere: ground truth for any view.
TEST_P(EveryScene, HasColoursThatDoNotDependOnTheViewer) {
    const auto scene = makeScene(GetParam(), 1);
    const Snapshot now = scene->at(0.4);
    int seen = 0;
    for (int i = 0; i < 400; ++i) {
        const int column = i % 20, row = i / 20;
        const glm::dvec3 direction{-0.7 + 0.07 * column, -0.4 + 0.04 * row, 1};
        const Hit here = now.trace({{0, 0, 0}, direction});
        const glm::dvec3 eye{0.15, -0.05, 0.1};
        const Hit there = now.trace({eye, glm::normalize(here.point - eye)});
        if (glm::distance(here.point, there.point) > 1e-9) continue; // something in between
        // Textures change by at most some 200 a millimetre: 1e-9 m are nothing.
        EXPECT_LT(glm::distance(here.color, there.color), 1e-3);
        ++seen;
    }
    EXPECT_GT(seen, 300);
}

INSTANTIATE_TEST_SUITE_P(All, EveryScene, ::testing::Values("room", "person", "calibration-board"));

TEST(PersonScene, StandsAtAboutFourteenHundredMillimetres) {
    const auto scene = makeScene("person", 1);
    for (const double time : {0.0, 1.0, 2.5, 4.0}) {
        const Hit chest = scene->trace({0, 0, 0}, {-0.27, 0.05, 1.4}, time);
        EXPECT_NEAR(chest.point.z, 1.35, 0.12) << time;
    }
}

TEST(PersonScene, MovesSmoothlyAndPeriodically) {
    constexpr double kFrame = 1.0 / 30;
    double farthest = 0;
    for (int frame = 0; frame < 180; ++frame) {
        const double time = kFrame * frame;
        const auto now = personAt(time), next = personAt(time + kFrame);
        const auto later = personAt(time + kPersonPeriodS);
        ASSERT_EQ(now.size(), later.size());
        for (std::size_t i = 0; i < now.size(); ++i) {
            const glm::dvec3 at = now[i].sceneFromBody.translation;
            EXPECT_LT(glm::distance(at, later[i].sceneFromBody.translation), 1e-9);
            farthest = std::max(farthest, glm::distance(at, next[i].sceneFromBody.translation));
        }
    }
    EXPECT_GT(farthest, 0.01); // the waving hand moves more than a centimetre a frame
    EXPECT_LT(farthest, 0.10); // and never jumps
}

TEST(CalibrationBoardScene, FaceIsTheBoardsPlane) {
    const auto scene = makeScene("calibration-board", 1);
    for (int moment = 0; moment < 35; ++moment) {
        const double time = moment * kBoardPeriodS / 35;
        const calib::RigidTransform pose = boardPose(time);
        for (const glm::dvec2 at : {glm::dvec2(0.01, 0.02), glm::dvec2(-0.2, 0.15)}) {
            const glm::dvec3 expected = pose * glm::dvec3(at, -kBoardHalfThicknessM);
            const Hit hit = scene->trace({0, 0, 0}, expected, time);
            EXPECT_NEAR(hit.distance, 1.0, 1e-9) << time;
        }
    }
}

TEST(CalibrationBoardScene, SquaresAlternateAroundEachInnerCorner) {
    const auto scene = makeScene("calibration-board", 1);
    const double time = 3.0;
    const calib::RigidTransform pose = boardPose(time);
    const auto brightness = [&](double x, double y) {
        return scene->trace({0, 0, 0}, pose * glm::dvec3(x, y, -kBoardHalfThicknessM), time)
            .color.g;
    };
    for (int row = 0; row < kBoardRows - 1; ++row) {
        for (int column = 0; column < kBoardColumns - 1; ++column) {
            const double x = (column + 1 - 0.5 * kBoardColumns) * kBoardSquareM;
            const double y = (row + 1 - 0.5 * kBoardRows) * kBoardSquareM;
            const double off = 0.4 * kBoardSquareM;
            const bool blackFirst = (row + column) % 2 == 0;
            EXPECT_EQ(brightness(x - off, y - off) < 60, blackFirst) << column << ' ' << row;
            EXPECT_EQ(brightness(x + off, y + off) < 60, blackFirst) << column << ' ' << row;
            EXPECT_EQ(brightness(x + off, y - off) < 60, !blackFirst) << column << ' ' << row;
            EXPECT_EQ(brightness(x - off, y + off) < 60, !blackFirst) << column << ' ' << row;
        }
    }
}

TEST(MakeScene, NamesTheScenesThatThereAre) {
    try {
        (void)makeScene("kitchen", 1);
        FAIL() << "no error";
    } catch (const AddressError& error) {
        EXPECT_NE(std::string(error.what()).find("room, person, calibration-board"),
                  std::string::npos);
    }
}

} // namespace
} // namespace autostereo::devices::sim
