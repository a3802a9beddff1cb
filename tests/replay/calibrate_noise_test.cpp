// `calibrate noise`: the simulated camera's noise, found again in its frames.

#include "tests/replay/pictures.hpp"
#include "tests/replay/program.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <sstream>

namespace autostereo::test {
namespace {

std::string textOf(const std::string& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

TEST(CalibrateNoise, FindsTheSimulatedCamerasAndWritesAConfiguration) {
    const TempFolder folder;
    const auto result = runProgram(calling({"calibrate", "noise", "--input", kSmallRoom, "--frames",
                                            "30", "--output", folder / "noise.toml", "--json"}));
    ASSERT_TRUE(succeeded(result));
    const auto found = nlohmann::json::parse(result.out);
    // The figures of config/default.toml, which are those of this camera.
    EXPECT_NEAR(found.at("noise_floor_mm"), 1.8, 0.5);
    EXPECT_NEAR(found.at("noise_shot_mm"), 3100, 500);
    EXPECT_LT(found.at("amplitude_residual"), 0.3);
    EXPECT_EQ(found.at("frames"), 30);

    const std::string text = textOf(folder / "noise.toml");
    EXPECT_NE(text.find("[condition]"), std::string::npos) << text;
    EXPECT_TRUE(succeeded(runProgram(calling({"check", folder / "noise.toml"}))));
    const auto table = runProgram(calling({"calibrate", "noise", "--input", kSmallRoom, "--frames",
                                           "30", "--output", folder / "noise.toml"}));
    EXPECT_TRUE(succeeded(table));
    EXPECT_NE(table.out.find("1.0 m"), std::string::npos) << table.out;
    EXPECT_NE(table.out.find("residual"), std::string::npos) << table.out;
}

TEST(CalibrateNoise, SaysWhereNothingCanBeMeasured) {
    const TempFolder folder;
    const std::string still = std::string(kSmallRoom) + "&noise=off";
    EXPECT_TRUE(
        failedPlainly(runProgram(calling({"calibrate", "noise", "--input", still, "--frames", "5",
                                          "--output", folder / "noise.toml"})),
                      1));
    EXPECT_FALSE(std::filesystem::exists(folder / "noise.toml"));
    EXPECT_TRUE(failedPlainly(runProgram(calling({"calibrate", "noise", "--input", kSmallRoom,
                                                  "--output", folder / "noise.txt"})),
                              2));
    EXPECT_TRUE(failedPlainly(runProgram(calling({"calibrate", "cameras"})), 2));
}

} // namespace
} // namespace autostereo::test
