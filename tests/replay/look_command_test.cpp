#include "tests/replay/pictures.hpp"
#include "tests/replay/program.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace autostereo::test {
namespace {

ProgramResult look(const std::string& panel, const std::string& display, const std::string& eye,
                   const std::string& output, const std::vector<std::string>& more = {}) {
    std::vector<std::string> words{"look",  "--panel", panel,      "--display", display,
                                   "--eye", eye,       "--output", output};
    words.insert(words.end(), more.begin(), more.end());
    return runProgram(calling(std::move(words)));
}

/// Half the fan of the eight-view display is 0.2276 m wide at 1 m; its views' middles are at 7/8.
constexpr const char* kLeftmost = "-0.1991,0,1";
constexpr const char* kRightmost = "0.1991,0,1";

/// The pattern's first hue is red, its last violet.
TEST(LookCommand, LeftmostEyeSeesRedAndRightmostViolet) {
    const TempFolder folder;
    const std::string panel = folder / "panel.png", eye = folder / "eye.png";
    const std::string display = "slanted-8view-1080p";
    ASSERT_TRUE(succeeded(
        runProgram(calling({"pattern", "colors", "--display", display, "--output", panel}))));

    ASSERT_TRUE(succeeded(look(panel, display, kLeftmost, eye)));
    const ColorPicture left = readColor(eye);
    ASSERT_EQ(left.width, 1920);
    ASSERT_EQ(left.height, 1080);
    const ProgramResult result = look(panel, display, kRightmost, eye, {"--json"});
    ASSERT_TRUE(succeeded(result));
    const ColorPicture right = readColor(eye);
    for (int y = 0; y < 1080; y += 7)
        for (int x = 0; x < 1920; x += 7) {
            const std::uint8_t *red = left.at(x, y), *violet = right.at(x, y);
            ASSERT_TRUE(red[0] == 255 && red[1] == 0 && red[2] == 0) << x << ' ' << y;
            ASSERT_TRUE(violet[0] == 204 && violet[1] == 0 && violet[2] == 255) << x << ' ' << y;
        }

    const auto figures = nlohmann::json::parse(result.out);
    EXPECT_EQ(figures.at("lit_subpixels"), 3 * 1920 * 1080 / 8) << "one of eight";
    EXPECT_NEAR(figures.at("mean_weight").get<double>(), 1.0 / 8, 1e-9);
    EXPECT_EQ(figures.at("aperture"), 0);
    EXPECT_NEAR(figures.at("gap_mm").get<double>(), 1.6187, 1e-4);
}

/// With crosstalk the neighbour's hue shows through: green, which red and violet have none of.
TEST(LookCommand, CrosstalkMixesNeighbours) {
    const TempFolder folder;
    const std::string panel = folder / "panel.png", eye = folder / "eye.png";
    ASSERT_TRUE(succeeded(runProgram(
        calling({"pattern", "colors", "--display", "slanted-8view-1080p", "--output", panel}))));
    ASSERT_TRUE(
        succeeded(look(panel, "slanted-8view-1080p", kLeftmost, eye, {"--crosstalk", "0.1"})));
    const ColorPicture seen = readColor(eye);
    EXPECT_GT(seen.at(960, 540)[1], 40);
    EXPECT_GT(seen.at(960, 540)[0], 240);
}

TEST(LookCommand, SaysWhatItCannotLookThrough) {
    const TempFolder folder;
    const std::string small = writeColor(folder / "small.png", 64, 32, [](int, int) {
        return Rgb{1, 2, 3};
    });
    const std::string eye = folder / "eye.png";
    const auto says = [&](const ProgramResult& result, const std::string& part) {
        EXPECT_TRUE(failedPlainly(result, 2));
        EXPECT_NE(result.err.find(part), std::string::npos) << result.err;
    };
    says(look(small, "slanted-8view-1080p", kLeftmost, eye), "small.png is 64x32");
    says(look(small, "slanted-8view-1080p", kLeftmost, eye), "has 1920x1080");
    says(look(small, "preview", kLeftmost, eye), "preview has no optics that are known");
    says(look(small, "slanted-8view-1080p", "0,0,0.001", eye), "behind the lenses or slits");
    says(look(small, "slanted-8view-1080p", "0,0,-1", eye), "allowed > 0");
    EXPECT_TRUE(failedPlainly(look(folder / "none.png", "slanted-8view-1080p", kLeftmost, eye)));
    EXPECT_FALSE(std::filesystem::exists(eye));
}

} // namespace
} // namespace autostereo::test
