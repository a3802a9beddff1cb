#include "devices/replay/calibration_files.hpp"
#include "tests/replay/pictures.hpp"
#include "tests/replay/program.hpp"
#include "tests/support/data.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace autostereo::test {
namespace {

/// The mug stands 0.4 m in front of the camera, the window is 2 m away; what lies between them is
/// in the panel's plane.
class MugGeometry : public testing::Test {
  protected:
    void SetUp() override { AUTOSTEREO_NEED_DATA("k4a-mug/recording.mkv"); }

    [[nodiscard]] ProgramResult render(const char* as, const std::string& output) const {
        return runProgram(
            calling({"render", "--input", dataDir() / "k4a-mug/recording.mkv", "--display",
                     "slanted-8view-1080p", "--as", as, "--output", output}));
    }
    TempFolder folder;
};

TEST_F(MugGeometry, NearMovesLeftAndFarMovesRightAsTheEyeMovesRight) {
    ASSERT_TRUE(succeeded(render("views", folder / "views")));
    const ColorPicture leftmost = readColor(folder / "views/view_00.png");
    const ColorPicture rightmost = readColor(folder / "views/view_07.png");
    constexpr Block kPrintOnTheMug{115, 215, 70, 70}, kFrameOfTheWindow{560, 20, 50, 120};
    // The profile's budget lets a point move by 0.02 of the width each way from the middle, 7/8
    // of that to the outermost views: 22 of the tile's 640 pixels.
    constexpr int kReach = 28, kMost = 23;
    const int near = shiftOf(kPrintOnTheMug, leftmost, rightmost, kReach);
    const int far = shiftOf(kFrameOfTheWindow, leftmost, rightmost, kReach);
    EXPECT_LT(near, -3);
    EXPECT_GE(near, -kMost);
    EXPECT_GT(far, 3);
    EXPECT_LE(far, kMost);
}

TEST_F(MugGeometry, RegisteredDepthIsTheMeasuredOneProjected) {
    ASSERT_TRUE(succeeded(render("depth", folder / "depth.png")));
    const DepthPicture registered = readDepth(folder / "depth.png");
    const DepthPicture measured = readDepth(dataDir() / "k4a-mug/depth.png");
    const calib::SensorRig rig = devices::readCameraFile(dataDir() / "k4a-mug/camera.json").rig();

    constexpr int kStep = 3; // pixels between sample points
    int visible = 0, uncovered = 0;
    std::vector<double> differences;
    for (int y = 0; y < measured.height; y += kStep)
        for (int x = 0; x < measured.width; x += kStep) {
            const auto ray = rig.depth.unproject({x, y});
            const double z = measured.at(x, y) / 1000.0;
            if (!ray || z < 0.2) continue; // nearer than the default's nearest_m, or none
            const glm::dvec3 point = rig.colorFromDepth * glm::dvec3{*ray * z, z};
            const auto pixel = rig.color.project(point);
            if (!pixel || pixel->x < 0 || pixel->y < 0 || pixel->x > registered.width - 1 ||
                pixel->y > registered.height - 1)
                continue;
            ++visible;
            const int found = registered.at(static_cast<int>(std::lround(pixel->x)),
                                            static_cast<int>(std::lround(pixel->y)));
            if (found == 0)
                ++uncovered;
            else
                differences.push_back(std::abs(found - 1000 * point.z));
        }
    ASSERT_GT(visible, 10'000);
    // Lone points between cuts make no triangle; the other points stand on the mesh, off by the
    // slope of the surface within half a pixel and by the rounding to a millimetre.
    EXPECT_LT(uncovered, visible / 10);
    std::ranges::nth_element(differences, differences.begin() +
                                              static_cast<std::ptrdiff_t>(differences.size() / 2));
    EXPECT_LT(differences[differences.size() / 2], 2.0);
}

/// A near square in front of a wall, both textured; the wall is in the panel's plane because it
/// fills most of the central third.
TEST(KnownGeometry, ASquareInFrontMovesByItsDisparity) {
    const TempFolder folder;
    constexpr int kWidth = 320, kHeight = 180, kWall = 2000, kSquare = 1900;
    const auto inSquare = [](int x, int y) { return x >= 60 && x < 120 && y >= 60 && y < 120; };
    const auto texture = [](int x, int y) {
        const auto grey = static_cast<std::uint8_t>(128 + 60 * std::sin(x * 0.9 + y * 0.31) +
                                                    60 * std::sin(x * 0.23 - y * 0.77));
        return Rgb{grey, grey, grey};
    };
    const std::string input =
        "rgbd:" + writeColor(folder / "color.png", kWidth, kHeight, texture) + "," +
        writeDepth(folder / "depth.png", kWidth, kHeight,
                   [&](int x, int y) { return inSquare(x, y) ? kSquare : kWall; }) +
        "," + cameraFile(folder, kWidth, kHeight);
    ASSERT_TRUE(
        succeeded(runProgram(calling({"render", "--input", input, "--display", smallDisplay(folder),
                                      "--as", "views", "--output", folder / "views"}))));
    const ColorPicture leftmost = readColor(folder / "views/view_00.png");
    const ColorPicture rightmost = readColor(folder / "views/view_07.png");
    // Camera: as wide as far (focal length = width), so the wall's 2 m fill the panel's 0.5313 m
    // and 0.1 m are Z = 26.6 mm. d = Bx Z / (D - Z), Bx = D tan(cone / 2) / W; from b = -7/8 to 7/8
    // that is 2 * 7/8 * d * 160 pixels = 3.3.
    EXPECT_EQ(shiftOf({100, 20, 40, 50}, leftmost, rightmost, 8), 0);
    EXPECT_NEAR(shiftOf({35, 35, 20, 20}, leftmost, rightmost, 8), -3.3, 0.8);
}

} // namespace
} // namespace autostereo::test
