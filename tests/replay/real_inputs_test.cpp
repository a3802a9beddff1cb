#include "tests/replay/pictures.hpp"
#include "tests/replay/program.hpp"
#include "tests/support/data.hpp"

#include <gtest/gtest.h>

namespace autostereo::test {
namespace {

/// What the data's README says where the folder itself has no camera.json.
constexpr const char* kRedKitchenCameras = R"({
 "depth": {"width": 640, "height": 480, "fx": 585, "fy": 585, "cx": 320, "cy": 240},
 "color": {"width": 640, "height": 480, "fx": 527.7, "fy": 527.7, "cx": 321.0, "cy": 238.3},
 "depth_to_color": {"R_rowmajor": [1, 0, 0, 0, 1, 0, 0, 0, 1], "t_m": [-0.0252, 0, 0]}})";
constexpr const char* kDeskCameras = R"({
 "depth": {"width": 640, "height": 360, "fx": 460, "fy": 460, "cx": 319.5, "cy": 179.5},
 "color": {"width": 640, "height": 360, "fx": 460, "fy": 460, "cx": 319.5, "cy": 179.5}})";

struct RealInput {
    const char* name;
    const char* scheme;
    const char* data;
    const char* cameras; ///< nullptr: the input's own
    int colorWidth, colorHeight;
    std::uint64_t pairs; ///< of the first two
};

std::ostream& operator<<(std::ostream& out, const RealInput& input) { return out << input.name; }

class RealInputs : public testing::TestWithParam<RealInput> {
  protected:
    void SetUp() override { AUTOSTEREO_NEED_DATA(GetParam().data); }

    [[nodiscard]] std::vector<std::string> command(const char* word,
                                                   const std::string& display) const {
        const RealInput& input = GetParam();
        std::vector<std::string> arguments{word, "--input",
                                           input.scheme + (dataDir() / input.data).string(),
                                           "--display", display};
        if (input.cameras != nullptr)
            arguments.insert(arguments.end(),
                             {"--rig", folder.file("cameras.json", input.cameras)});
        return arguments;
    }

    [[nodiscard]] ProgramResult render(const char* as, const std::string& display,
                                       const std::string& output) const {
        auto arguments = command("render", display);
        arguments.insert(arguments.end(), {"--as", as, "--output", output});
        return runProgram(calling(arguments));
    }

    TempFolder folder;
};

/// Real rooms have contrast; a picture that was mostly not drawn has it too, but is black.
void expectPicture(const ColorPicture& picture, int width, int height) {
    constexpr double kLeastContrast = 20, kMostBlack = 0.3;
    EXPECT_EQ(picture.width, width);
    EXPECT_EQ(picture.height, height);
    EXPECT_GT(contrast(picture), kLeastContrast);
    std::size_t black = 0;
    for (const std::uint8_t sample : picture.rgb)
        black += sample == 0 ? 1U : 0U;
    EXPECT_LT(static_cast<double>(black), kMostBlack * static_cast<double>(picture.rgb.size()));
}

TEST_P(RealInputs, RunDrawsFrames) {
    auto arguments = command("run", smallDisplay(folder));
    arguments.insert(arguments.end(),
                     {"--output", "offscreen", "--speed", "max", "--frames", "2", "--report",
                      folder / "report.json", "--snapshot", folder / "panel.png"});
    ASSERT_TRUE(succeeded(runProgram(calling(arguments))));
    expectPicture(readColor(folder / "panel.png"), kSmallWidth, kSmallHeight);
    const RunReport report = readReport(folder / "report.json");
    EXPECT_TRUE(balanced(report));
    EXPECT_EQ(report.accounts.presented, GetParam().pairs);
    EXPECT_EQ(report.latencyP50Ms, std::nullopt) << "unpaced frames have no latency";
}

TEST_P(RealInputs, RendersQuiltViewsEyeAndDepth) {
    const std::string display = smallDisplay(folder);
    ASSERT_TRUE(succeeded(render("quilt", display, folder / "quilt.png")));
    expectPicture(readColor(folder / "quilt.png"), 4 * kSmallTileWidth, 2 * kSmallTileHeight);

    ASSERT_TRUE(succeeded(render("views", display, folder / "views")));
    for (int view = 0; view < kSmallViews; ++view)
        expectPicture(readColor(folder / ("views/view_0" + std::to_string(view) + ".png")),
                      kSmallTileWidth, kSmallTileHeight);

    ASSERT_TRUE(succeeded(render("view", display, folder / "view.png")));
    expectPicture(readColor(folder / "view.png"), kSmallWidth, kSmallHeight);

    ASSERT_TRUE(succeeded(render("depth", display, folder / "depth.png")));
    const DepthPicture depth = readDepth(folder / "depth.png");
    EXPECT_EQ(depth.width, GetParam().colorWidth);
    EXPECT_EQ(depth.height, GetParam().colorHeight);
}

TEST_P(RealInputs, FillTheShippedDisplays) {
    ASSERT_TRUE(succeeded(render("panel", "slanted-8view-1080p", folder / "eight.png")));
    expectPicture(readColor(folder / "eight.png"), 1920, 1080);
    ASSERT_TRUE(succeeded(render("panel", "barrier-5view", folder / "five.png")));
    expectPicture(readColor(folder / "five.png"), 1600, 1200);
    ASSERT_TRUE(succeeded(render("panel", "preview", folder / "preview.png")));
    expectPicture(readColor(folder / "preview.png"), 1920, 1080);
}

INSTANTIATE_TEST_SUITE_P(
    Data, RealInputs,
    testing::Values(RealInput{"K4aMug", "", "k4a-mug/recording.mkv", nullptr, 1280, 720, 1},
                    RealInput{"TumRpy", "tum:", "tum-fr1-rpy", nullptr, 640, 480, 2},
                    RealInput{"RedKitchen", "seq:", "rgbd-redkitchen", kRedKitchenCameras, 640, 480,
                              2},
                    RealInput{"DeskPerson", "seq:", "rgbd-desk-person", kDeskCameras, 640, 360, 2}),
    [](const auto& tested) { return std::string(tested.param.name); });

TEST(RealInput, FillsThePortrait) {
    AUTOSTEREO_NEED_DATA("k4a-mug/recording.mkv");
    const TempFolder folder;
    const std::string mug = dataDir() / "k4a-mug/recording.mkv";
    ASSERT_TRUE(succeeded(
        runProgram(calling({"render", "--input", mug, "--display", "looking-glass-portrait", "--as",
                            "panel", "--output", folder / "panel.png"}))));
    expectPicture(readColor(folder / "panel.png"), 1536, 2048);
}

} // namespace
} // namespace autostereo::test
