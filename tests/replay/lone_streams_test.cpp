#include "tests/replay/pictures.hpp"
#include "tests/replay/program.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace autostereo::test {
namespace {

/// Stills of the size of a tile, so that a flat picture is shown one to one.
constexpr int kWidth = kSmallTileWidth, kHeight = kSmallTileHeight;

Rgb smoothColors(int x, int y) {
    return {static_cast<std::uint8_t>(40 + x), static_cast<std::uint8_t>(250 - 2 * y),
            static_cast<std::uint8_t>(60 + x / 2 + y)};
}

class LoneStreams : public testing::Test {
  protected:
    [[nodiscard]] std::string color() const {
        return writeColor(folder / "color.png", kWidth, kHeight, smoothColors);
    }
    [[nodiscard]] std::string depth(const std::function<int(int, int)>& millimetres) const {
        return writeDepth(folder / "depth.png", kWidth, kHeight, millimetres);
    }
    /// All views of a still; run on it ends well, too, with its one pair accounted for.
    [[nodiscard]] std::vector<ColorPicture> views(const std::string& colorFile,
                                                  const std::string& depthFile) const {
        const std::string input =
            "rgbd:" + colorFile + "," + depthFile + "," + cameraFile(folder, kWidth, kHeight);
        const std::string display = smallDisplay(folder);
        EXPECT_TRUE(succeeded(runProgram(calling(
            {"run", "--input", input, "--display", display, "--output", "offscreen", "--speed",
             "max", "--snapshot", folder / "panel.png", "--report", folder / "report.json"}))));
        const RunReport report = readReport(folder / "report.json");
        EXPECT_TRUE(balanced(report));
        EXPECT_EQ(report.accounts.presented, 1U);

        EXPECT_TRUE(
            succeeded(runProgram(calling({"render", "--input", input, "--display", display, "--as",
                                          "views", "--output", folder / "views"}))));
        std::vector<ColorPicture> pictures;
        pictures.reserve(kSmallViews);
        for (int view = 0; view < kSmallViews; ++view)
            pictures.push_back(
                readColor(folder / ("views/view_0" + std::to_string(view) + ".png")));
        return pictures;
    }
    TempFolder folder;
};

/// Middle of the picture, away from what a far background leaves uncovered at the edges.
int largestDifferenceInTheMiddle(const ColorPicture& a, const ColorPicture& b) {
    int largest = 0;
    for (int y = kHeight / 8; y < kHeight * 7 / 8; ++y)
        for (int x = kWidth / 8; x < kWidth * 7 / 8; ++x)
            for (int channel = 0; channel < 3; ++channel)
                largest = std::max(largest, std::abs(a.at(x, y)[channel] - b.at(x, y)[channel]));
    return largest;
}

ColorPicture original() {
    ColorPicture picture{kWidth, kHeight, {}};
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const auto [red, green, blue] = smoothColors(x, y);
            picture.rgb.insert(picture.rgb.end(), {red, green, blue});
        }
    return picture;
}

TEST_F(LoneStreams, ColorAloneIsTheFlatPictureInThePanelsPlane) {
    const auto pictures = views(color(), "");
    for (const ColorPicture& picture : pictures)
        EXPECT_LE(compareImages(picture.view(), pictures.front().view()).max, 1);
    // The framing zooms by 4 to 5 % to cover the overscan: 2.7 pixels at 3/8 of the width, each
    // worth 1, and 1.6 of the height, each worth 2.
    EXPECT_LE(largestDifferenceInTheMiddle(pictures.front(), original()), 4);
    EXPECT_EQ(readReport(folder / "report.json").accounts.withoutDepth, 0U);
}

TEST_F(LoneStreams, DepthAloneIsShadedGrey) {
    // A wall that recedes to the right, with a step: shading and edges to see.
    const auto pictures =
        views("", depth([](int x, int y) { return (y < 40 ? 1000 : 1500) + 4 * x; }));
    for (const ColorPicture& picture : pictures) {
        for (std::size_t i = 0; i < picture.rgb.size(); i += 3) {
            ASSERT_EQ(picture.rgb[i], picture.rgb[i + 1]);
            ASSERT_EQ(picture.rgb[i], picture.rgb[i + 2]);
        }
        EXPECT_GT(contrast(picture), 3) << "flat";
        EXPECT_GT(picture.at(kWidth / 2, kHeight / 2)[0], 20) << "black";
    }
}

class NoMeasurement : public LoneStreams, public testing::WithParamInterface<int> {};

TEST_P(NoMeasurement, ShowsTheColorPicture) {
    const auto pictures = views(color(), depth([](int, int) { return GetParam(); }));
    EXPECT_EQ(readReport(folder / "report.json").accounts.withoutDepth, 1U);
    // The background lies as far back as the display shows: 0.02 of the width times b = +-7/8 of
    // the fan, 2.8 of 160 pixels sideways, each worth 1; and the zoom as above.
    for (const ColorPicture& picture : pictures)
        EXPECT_LE(largestDifferenceInTheMiddle(picture, original()), 7);
}

INSTANTIATE_TEST_SUITE_P(Depth, NoMeasurement, testing::Values(0, 65535),
                         [](const auto& tested) { return std::to_string(tested.param); });

} // namespace
} // namespace autostereo::test
