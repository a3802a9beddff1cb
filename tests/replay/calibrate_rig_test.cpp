// `calibrate cameras` and `calibrate rig`: from pictures to a file that `check` explains.

#include "tests/replay/program.hpp"
#include "tests/support/data.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>

namespace autostereo::test {
namespace {

std::vector<std::string> tofPictures(const std::string& kind) {
    std::vector<std::string> files;
    for (const char* number : {"1", "3", "4", "5", "6", "7", "8"})
        files.push_back(dataDir() / "tof-chess" / (std::string(number) + kind));
    return files;
}

ProgramResult call(std::vector<std::string> arguments) {
    return runProgram(calling(std::move(arguments)));
}

TEST(CalibrateRig, MakesARigOfPicturesThatCheckExplains) {
    AUTOSTEREO_NEED_DATA("tof-chess/1_ir.png");
    const TempFolder folder;
    const std::string rig = folder.file("rig.toml", "# the one before\n");
    std::vector<std::string> arguments{"calibrate",        "rig",      "--board", "11x8",
                                       "--json",           "--output", rig,       "--opencv",
                                       folder / "rig.yml", "--depth"};
    for (const std::string& file : tofPictures("_ir.png"))
        arguments.push_back(file);
    arguments.emplace_back("--color");
    for (const std::string& file : tofPictures("_color.jpg"))
        arguments.push_back(file);
    const auto result = call(arguments);
    ASSERT_TRUE(succeeded(result));
    const auto found = nlohmann::json::parse(result.out);
    EXPECT_LE(found.at("rms_px"), 0.30);
    EXPECT_EQ(found.at("pairs"), 7);

    const auto checked = call({"check", rig});
    EXPECT_TRUE(succeeded(checked));
    EXPECT_NE(checked.out.find("both cameras: 0.2"), std::string::npos) << checked.out;
    EXPECT_NE(checked.out.find("k3 = 0"), std::string::npos) << checked.out;
    std::ifstream old(rig + ".old");
    std::string line;
    EXPECT_TRUE(std::getline(old, line));
    EXPECT_EQ(line, "# the one before");
    EXPECT_TRUE(std::filesystem::exists(folder / "rig.yml"));
}

TEST(CalibrateRig, FromListedPoints) {
    const TempFolder folder;
    const std::string rig = twoCameras(folder);
    // A camera 50 mm to the right: x moves by -500 * 50 / depth.
    const std::string points = folder.file("points.txt", "# depth x y mm, colour x y\n"
                                                         "100 100 1000  75 100\n"
                                                         "540 100 2000  527.5 100\n"
                                                         "100 400 2500  90 400\n"
                                                         "540 400 1250  520 400\n"
                                                         "320 240 500  270 240\n"
                                                         "200 300 1000  175 300 # here\n"
                                                         "450 180 2000  437.5 180\n");
    const auto result = call({"calibrate", "rig", "--pairs", points, "--rig", rig, "--json",
                              "--output", folder / "rig.toml"});
    ASSERT_TRUE(succeeded(result));
    EXPECT_LT(nlohmann::json::parse(result.out).at("rms_px"), 1e-6);
    const auto checked = call({"check", folder / "rig.toml"});
    EXPECT_NE(checked.out.find("stands 50.0, "), std::string::npos) << checked.out << checked.err;
}

TEST(CalibrateRig, RefusesInOneLine) {
    const TempFolder folder;
    const std::string toml = folder / "rig.toml";
    const auto refused = [&](std::vector<std::string> arguments, int code) {
        arguments.insert(arguments.begin(), "calibrate");
        arguments.insert(arguments.end(), {"--output", toml});
        EXPECT_TRUE(failedPlainly(call(arguments), code));
        EXPECT_FALSE(std::filesystem::exists(toml));
    };
    refused({"cameras"}, 2);
    refused({"cameras", "--color", "none.png", "--board", "9by6"}, 2);
    refused({"cameras", "--color", folder / "none.png"}, 3);
    refused({"cameras", "--color", "none.png", "--dictionary", "9x9_50"}, 2);
    refused({"rig", "--pairs", folder / "none.txt"}, 2);
    refused({"rig", "--input", std::string(kSmallRoom) + "&frames=8", "--every", "1"}, 1);
}

} // namespace
} // namespace autostereo::test
