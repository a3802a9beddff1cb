// `run` keeps the scene inside the display's depth budget; `render` shows what a single picture
// says.

#include "tests/replay/pictures.hpp"
#include "tests/replay/program.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <cstdlib>
#include <fstream>

namespace autostereo::test {
namespace {

/// A wall at 3 m, and from picture `arrival` on a visitor at 1 m in the middle third; 10 pictures a
/// second.
std::string visit(const TempFolder& folder, int pictures, int arrival) {
    for (int i = 0; i < pictures; ++i) {
        char name[64];
        std::snprintf(name, sizeof name, "frame-%06d.color.png", i);
        writeColor(folder / name, 48, 36, [](int x, int y) {
            return Rgb{static_cast<std::uint8_t>(5 * x), static_cast<std::uint8_t>(7 * y), 90};
        });
        std::snprintf(name, sizeof name, "frame-%06d.depth.png", i);
        writeDepth(folder / name, 48, 36, [&](int x, int /*y*/) {
            return i >= arrival && x >= 16 && x < 32 ? 1000 : 3000;
        });
    }
    return "seq:" + (folder / "") + "?fps=10";
}

nlohmann::json depthAfter(const TempFolder& folder, const std::string& input, const char* frames,
                          const std::string& config) {
    const auto result = runProgram(calling(
        {"run", "--input", input, "--display", smallDisplay(folder), "--rig",
         cameraFile(folder, 48, 36), "--config", folder.file("config.toml", config), "--output",
         "offscreen", "--speed", "max", "--frames", frames, "--report", folder / "report.json"}));
    EXPECT_TRUE(succeeded(result));
    std::ifstream report(folder / "report.json");
    return nlohmann::json::parse(report).at("depth");
}

TEST(DepthBudget, FollowsAVisitorAndStaysInItsLimits) {
    const TempFolder folder;
    const std::string input = visit(folder, 40, 8);
    const auto before = depthAfter(folder, input, "8", "");
    EXPECT_NEAR(before.at("focus_m"), 3, 0.04);
    EXPECT_EQ(before.at("clamped_share"), 0);
    const auto after = depthAfter(folder, input, "40", "[depth]\ntime_constant_s = 0.5\n");
    EXPECT_NEAR(after.at("focus_m"), 1, 0.04);
    EXPECT_GT(after.at("clamped_share"), 0.4);
    const auto bounded =
        depthAfter(folder, input, "40", "[depth]\ntime_constant_s = 0.5\nfocus_range_m = [2, 4]\n");
    EXPECT_NEAR(bounded.at("focus_m"), 2, 0.04);
    const auto fixed = depthAfter(folder, input, "40", "[depth]\nfollow = \"never\"\n");
    EXPECT_EQ(fixed.at("focus_m"), 3);
    EXPECT_NEAR(fixed.at("scale"), 1, 1e-12);
    EXPECT_TRUE(fixed.at("clamped_share").is_null());
    const auto numbers = depthAfter(folder, input, "12", "[depth]\nfocus_m = 1.5\nscale = 0.25\n");
    EXPECT_EQ(numbers.at("focus_m"), 1.5);
    EXPECT_NEAR(numbers.at("scale"), 0.25, 1e-12);
}

} // namespace
} // namespace autostereo::test
