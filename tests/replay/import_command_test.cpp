#include "config/load.hpp"
#include "devices/input.hpp"
#include "tests/replay/program.hpp"
#include "tests/support/data.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace autostereo::test {
namespace {

constexpr const char* kUnit = R"({"serial": "LKG-PORT-1", "pitch": {"value": 52.5},
"slope": {"value": -7.1}, "center": {"value": 0.4}, "viewCone": {"value": 40}, "DPI": 324,
"screenW": 1536, "screenH": 2048, "flipImageX": {"value": 0}})";

ProgramResult call(std::vector<std::string> arguments) {
    return runProgram(calling(std::move(arguments)));
}

TEST(ImportCommand, WritesAFileThatChecks) {
    const TempFolder folder;
    const std::string json = folder.file("visual.json", kUnit), toml = folder / "mine.toml";
    const ProgramResult result = call({"import", "looking-glass", json, "--output", toml});
    ASSERT_TRUE(succeeded(result));
    EXPECT_EQ(result.out, toml + ": Looking Glass Portrait 7.9 inch, unit LKG-PORT-1 (built on "
                                 "looking-glass-portrait-template)\n");
    EXPECT_EQ(result.err, "");
    const ProgramResult checked = call({"check", json, toml});
    EXPECT_TRUE(succeeded(checked));
    EXPECT_EQ(std::ranges::count(checked.out, '\n'), 2) << checked.out;
    EXPECT_TRUE(succeeded(
        call({"import", "cubevi", folder.file("c.json", R"({"lineNumber": 19.6, "obliquity": 0.1,
"deviation": 8.9})"),
              "--view-order", "left_to_right", "--output", toml})));
}

/// The JSON itself as --display gives the picture that the imported file gives.
TEST(ImportCommand, TheJsonIsADisplayToo) {
    const TempFolder folder;
    const std::string json = folder.file("visual.json", kUnit), toml = folder / "mine.toml";
    ASSERT_TRUE(succeeded(call({"import", "looking-glass", json, "--output", toml})));
    for (const auto& [display, map] : {std::pair{json, "json.npy"}, {toml, "toml.npy"}})
        ASSERT_TRUE(succeeded(call({"viewmap", "--display", display, "--output", folder / map})));
    ProgramCall comparison;
    comparison.program = "/usr/bin/cmp";
    comparison.arguments = {folder / "json.npy", folder / "toml.npy"};
    EXPECT_TRUE(succeeded(runProgram(comparison)));
}

TEST(ImportCommand, RefusesInOneLine) {
    const TempFolder folder;
    const std::string good = folder.file("visual.json", kUnit), toml = folder / "mine.toml";
    const auto refused = [&](std::vector<std::string> arguments, const std::string& message) {
        arguments.insert(arguments.begin(), "import");
        const ProgramResult result = call(arguments);
        EXPECT_TRUE(failedPlainly(result, 2));
        EXPECT_EQ(result.err, "autostereo: " + message + '\n');
        EXPECT_FALSE(std::filesystem::exists(toml));
    };
    refused({"kinect2", good, "--output", toml}, good + ": ir.fx: missing (a number is needed)");
    refused({"tv", good, "--output", toml},
            "import: tv is not known (allowed cubevi, k4a, kinect2, looking-glass, opencv, ros)");
    refused({"opencv", good, "--output", toml},
            good + ": camera_matrix: missing (allowed camera_matrix, cameraMatrix, K, M1 and M2, "
                   "or rotation and translation)");
    refused({"opencv", good, "--depth-size", "12", "--output", toml},
            "--depth-size: 12 is no size (allowed e.g. 640x576)");
    refused({"looking-glass", good, "--output", folder / "mine.json"},
            "--output: " + (folder / "mine.json") + " is no display file (allowed *.toml)");
    refused({"looking-glass", good, "--output", toml, "--view-order", "up"},
            "--view-order: up is not known (allowed left_to_right, right_to_left)");
    refused({"looking-glass", folder / "none.json", "--output", toml},
            (folder / "none.json") + ": cannot be read: No such file or directory");
    refused({"looking-glass", folder / "", "--output", toml},
            (folder / "") + ": cannot be read: Is a directory");
    const std::string zeros = folder.file("zeros.json", R"({"serial": "LKG-E0", "pitch": 0,
"slope": 0, "DPI": 0, "screenW": 0, "screenH": 0})");
    const std::string problem = ": pitch: 0, and so is every number: the display served no "
                                "calibration (unplug its USB cable and plug it in again)";
    refused({"looking-glass", zeros, "--output", toml}, zeros + problem);
    const ProgramResult asDisplay = call({"render", "--input", kSmallRoom, "--display", zeros,
                                          "--as", "panel", "--output", folder / "p.png"});
    EXPECT_TRUE(failedPlainly(asDisplay, 2));
    EXPECT_EQ(asDisplay.err, "autostereo: " + zeros + problem + '\n');
    EXPECT_EQ(call({"check", zeros}).err, zeros + problem + '\n');
    refused({"looking-glass", good, "--base", "preview", "--output", toml},
            toml + ":3:8: base: \"preview\" is of type anaglyph (allowed displays of the file's "
                   "own type)");
}

/// The factory's numbers are those that a recording of the same camera carries.
TEST(ImportCommand, AnAzureKinectsOwnCalibration) {
    AUTOSTEREO_NEED_DATA("camera-calibrations/azure-kinect-b.json");
    AUTOSTEREO_NEED_DATA("k4a-mug/recording.mkv");
    const TempFolder folder;
    const std::string rig = folder / "rig.toml";
    ASSERT_TRUE(
        succeeded(call({"import", "k4a", dataDir() / "camera-calibrations/azure-kinect-b.json",
                        "--color-size", "1280x720", "--output", rig})));
    const calib::SensorRig imported = config::loadRig(rig);
    const calib::SensorRig recorded = *devices::openInput(dataDir() / "k4a-mug/recording.mkv").rig;
    EXPECT_EQ(imported.depth.intrinsics.fx, recorded.depth.intrinsics.fx);
    EXPECT_EQ(imported.color.intrinsics.cy, recorded.color.intrinsics.cy);
    EXPECT_EQ(imported.color.distortion.k6, recorded.color.distortion.k6);
    EXPECT_EQ(imported.colorFromDepth.translation, recorded.colorFromDepth.translation);
}

TEST(ImportCommand, AKinectsFilesOfAnotherProgram) {
    AUTOSTEREO_NEED_DATA("camera-calibrations/kinect-v2/calib_pose.yaml");
    const TempFolder folder;
    const std::string rig = folder / "rig.toml",
                      files = dataDir() / "camera-calibrations/kinect-v2";
    ASSERT_TRUE(
        succeeded(call({"import", "opencv", files + "/calib_ir.yaml", "--color",
                        files + "/calib_color.yaml", "--pose", files + "/calib_pose.yaml",
                        "--depth-size", "512x424", "--color-size", "1920x1080", "--output", rig})));
    const calib::SensorRig imported = config::loadRig(rig);
    EXPECT_EQ(imported.depth.intrinsics.width, 512);
    EXPECT_NEAR(imported.color.intrinsics.fx, 1066.0120360637927, 1e-9);
    EXPECT_NEAR(imported.colorFromDepth.translation.x, -0.052017152124108991, 1e-15);
}

TEST(ImportCommand, AKinectsParametersOfLibfreenect2) {
    // A pinhole colour camera: the colour terms by hand, with the library's scale of 0.01 and
    // 0.002199.
    const TempFolder folder;
    const std::string rig = folder / "rig.toml";
    const std::string file = folder.file(
        "unit.json",
        R"({"ir": {"fx": 365.4, "fy": 365.4, "cx": 256.2, "cy": 207.9, "k1": 0.09, "k2": -0.27,
                   "k3": 0.09, "p1": 0, "p2": 0},
            "color": {"fx": 1081.37, "fy": 1081.37, "cx": 959.5, "cy": 539.5, "shift_d": 863,
                      "shift_m": 52,
                      "mx_x3y0": 0, "mx_x0y3": 0, "mx_x2y1": 0, "mx_x1y2": 0, "mx_x2y0": 0,
                      "mx_x0y2": 0, "mx_x1y1": 0, "mx_x1y0": 0.65, "mx_x0y1": 0, "mx_x0y0": 0.03,
                      "my_x3y0": 0, "my_x0y3": 0, "my_x2y1": 0, "my_x1y2": 0, "my_x2y0": 0,
                      "my_x0y2": 0, "my_x1y1": 0, "my_x1y0": 0, "my_x0y1": 0.65,
                      "my_x0y0": -0.02}})");
    ASSERT_TRUE(succeeded(call({"import", "kinect2", file, "--output", rig})));
    const calib::SensorRig imported = config::loadRig(rig);
    EXPECT_NEAR(imported.depth.intrinsics.cx, 255.7, 1e-9) << "from the first pixel's centre";
    EXPECT_NEAR(imported.color.intrinsics.fx, 365.4 * 0.01 * 0.65 / 0.002199, 0.5);
    EXPECT_NEAR(imported.colorFromDepth.translation.x,
                0.052 * 1081.37 / imported.color.intrinsics.fx, 1e-4);
}

TEST(ImportCommand, OutputThatCannotBeWritten) {
    const TempFolder folder;
    const std::string toml = folder / "none/mine.toml";
    const ProgramResult result =
        call({"import", "looking-glass", folder.file("visual.json", kUnit), "--output", toml});
    EXPECT_TRUE(failedPlainly(result, 1));
    EXPECT_EQ(result.err,
              "autostereo: import: cannot write " + toml + ": No such file or directory\n");
}

} // namespace
} // namespace autostereo::test
