// From two cameras without numbers to a panel: what a technician does, on simulated cameras.

#include "config/load.hpp"
#include "config/rig_file.hpp"
#include "devices/input.hpp"
#include "tests/replay/program.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <optional>

namespace autostereo::test {
namespace {

constexpr const char* kCameras = "?depth=640x576&color=1280x720&noise=off";

/// Where colour is looked up for depth pixels of the picture's middle (where the board was seen) at
/// a range, against where it is: 95th percentile, mm on a surface at that range.
double registrationErrorMm(const calib::SensorRig& rig, const calib::SensorRig& truth,
                           double rangeM) {
    const calib::Intrinsics& size = truth.depth.intrinsics;
    std::vector<double> errors;
    for (int y = size.height / 4; y < 3 * size.height / 4; y += 16)
        for (int x = size.width / 4; x < 3 * size.width / 4; x += 16) {
            const auto seenIn = [&](const calib::SensorRig& with) -> std::optional<glm::dvec2> {
                const auto ray = with.depth.unproject({x, y});
                if (!ray) return std::nullopt;
                return with.color.project(with.colorFromDepth * (rangeM * glm::dvec3(*ray, 1.0)));
            };
            const auto found = seenIn(rig), right = seenIn(truth);
            if (found && right)
                errors.push_back(1000 * rangeM * glm::distance(*found, *right) /
                                 truth.color.intrinsics.fx);
        }
    std::ranges::sort(errors);
    return errors.at(errors.size() * 95 / 100);
}

/// The numbers of a simulated input, as a rig file.
std::string exactRig(const std::string& input) {
    const calib::SensorRig rig = *devices::openInput(input).rig;
    return config::rigText({rig.depth, rig.color, rig.colorFromDepth, "exact", {}, {}});
}

TEST(CalibrationFlow, CamerasThenRigThenPanel) {
    const TempFolder folder;
    const std::string board = "sim:calibration-board" + std::string(kCameras) + "&fps=1";
    const auto calibrate = [&](const std::string& what, const std::string& file) {
        ProgramCall call = calling({"calibrate", what, "--input", board, "--views", "12", "--every",
                                    "2", "--square-mm", "60", "--json", "--output", file});
        call.limit = std::chrono::minutes(4); // 24 boards to find, under a sanitizer too
        return runProgram(call);
    };
    ASSERT_TRUE(succeeded(calibrate("cameras", folder / "cameras.toml")));
    const ProgramResult result = calibrate("rig", folder / "rig.toml");
    ASSERT_TRUE(succeeded(result));
    const auto stated = nlohmann::json::parse(result.out);

    const calib::SensorRig truth = *devices::openInput("sim:room" + std::string(kCameras)).rig;
    const calib::SensorRig found = config::loadRig(folder / "rig.toml");
    for (const double rangeM : {0.5, 1.0, 2.0}) {
        const double error = registrationErrorMm(found, truth, rangeM);
        const double before = registrationErrorMm(config::exampleRig(), truth, rangeM);
        const std::string key = std::to_string(static_cast<int>(1000 * rangeM));
        std::printf("at %s mm: %.2f mm off, %.1f with nominal cameras\n", key.c_str(), error,
                    before);
        EXPECT_LE(error, stated.at("registration_95_mm_at_" + key + "_mm").get<double>());
        EXPECT_LT(error, 0.1 * before);
    }

    const std::string settings =
        folder.file("autostereo.toml", "[input]\nuri = \"sim:room" + std::string(kCameras) +
                                           "\"\nrig = \"rig.toml\"\n");
    const std::string report = folder / "report.json";
    EXPECT_TRUE(succeeded(
        runProgram(calling({"run", "--config", settings, "--display", smallDisplay(folder),
                            "--output", "offscreen", "--frames", "5", "--report", report}))));
}

// Some seconds of a moving board, whose colour camera's clock is 12 ms late.
TEST(CalibrationFlow, LateStampsAreFoundAndTakenOff) {
    const TempFolder folder;
    const std::string input = "sim:calibration-board?depth=320x288&color=640x360&noise=off&fps=15";
    const std::string rig = folder.file("rig.toml", exactRig(input));
    ProgramCall call =
        calling({"calibrate", "timing", "--input", input + "&color_late_ms=12", "--rig", rig,
                 "--views", "26", "--square-mm", "60", "--json", "--output", rig});
    call.limit = std::chrono::minutes(4);
    const ProgramResult result = runProgram(call);
    ASSERT_TRUE(succeeded(result));
    const auto found = nlohmann::json::parse(result.out);
    EXPECT_NEAR(found.at("color_late_ms").get<double>(), 12,
                found.at("color_late_95_ms").get<double>());
    EXPECT_LT(found.at("color_late_95_ms").get<double>(), 3);

    // The rig keeps its numbers, and pairs lie 4 ms apart again instead of 16.
    EXPECT_NEAR(config::loadRig(rig).colorLateS, 0.012, 0.003);
    const std::string report = folder / "report.json";
    const std::string settings = folder.file("autostereo.toml", "[sync]\ntolerance_ms = 8\n");
    for (const bool corrected : {false, true}) {
        std::vector<std::string> run{"run",
                                     "--config",
                                     settings,
                                     "--input",
                                     input + "&color_late_ms=12&frames=6",
                                     "--speed",
                                     "max",
                                     "--display",
                                     smallDisplay(folder),
                                     "--output",
                                     "offscreen",
                                     "--report",
                                     report};
        if (corrected) run.insert(run.end(), {"--rig", rig});
        const ProgramResult shown = runProgram(calling(run));
        const auto told = nlohmann::json::parse(std::ifstream(report), nullptr, false);
        EXPECT_EQ(told.value("frames_presented", 0) > 0, corrected) << shown.err;
    }
}

// The lenses stay; where the colour camera stands is told by the points that the depth camera
// measured.
TEST(CalibrationFlow, TheDepthCamerasOwnPointsPlaceTheColorCamera) {
    const TempFolder folder;
    const std::string input = "sim:calibration-board?depth=640x576&color=1280x720&fps=1";
    const std::string known = folder.file("known.toml", exactRig(input));
    ProgramCall call =
        calling({"calibrate", "rig", "--rig", known, "--input", input, "--views", "6", "--every",
                 "2", "--square-mm", "60", "--json", "--output", folder / "rig.toml"});
    call.limit = std::chrono::minutes(4);
    ASSERT_TRUE(succeeded(runProgram(call)));
    const calib::SensorRig truth = *devices::openInput(input).rig;
    const calib::SensorRig found = config::loadRig(folder / "rig.toml");
    EXPECT_EQ(found.color.intrinsics.fx, truth.color.intrinsics.fx);
    // Corners to a tenth of a pixel of 1.3 mm at 1 m, depth to 2 mm, six views.
    EXPECT_LT(glm::distance(found.colorFromDepth.translation, truth.colorFromDepth.translation),
              0.002);
}

// A board that drifts in front of running cameras, seen for 15 s: what is still and new is taken.
TEST(CalibrationFlow, LiveViewsAreTakenWhenTheyAreWorthIt) {
    const TempFolder folder;
    const std::string input = "sim:calibration-board?depth=320x288&color=640x360&fps=4&frames=60";
    ProgramCall call = calling({"calibrate", "cameras", "--live", "--input", input, "--views", "30",
                                "--square-mm", "60", "--output", folder / "cameras.toml"});
    call.environment = {"DISPLAY=", "WAYLAND_DISPLAY="};
    call.limit = std::chrono::minutes(4);
    const ProgramResult result = runProgram(call);
    ASSERT_TRUE(succeeded(result));
    EXPECT_NE(result.out.find("of 30: hold still; next: "), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("5 of 30: taken"), std::string::npos) << result.out;
    // Some views of a simulated lens without noise: a tenth of a pixel over a board 150 px wide.
    const calib::SensorRig truth = *devices::openInput(input).rig;
    const config::RigFile found = config::readRigFile(folder / "cameras.toml");
    EXPECT_NEAR(found.color.value().intrinsics.fx / truth.color.intrinsics.fx, 1, 0.01);
    EXPECT_NEAR(found.depth.value().intrinsics.fx / truth.depth.intrinsics.fx, 1, 0.01);
}

TEST(CalibrationFlow, OnlyAnInputCanBeWatched) {
    const ProgramResult result = runProgram(calling(
        {"calibrate", "cameras", "--live", "--color", "a.png", "--output", "cameras.toml"}));
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_NE(result.err.find("--live"), std::string::npos) << result.err;
}

} // namespace
} // namespace autostereo::test
