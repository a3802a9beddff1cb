// From patterns to a unit's own display file, with the program alone; photographs are simulated.

#include "config/load.hpp"
#include "config/rig_file.hpp"
#include "daemon/picture_files.hpp"
#include "devices/replay/image_files.hpp"
#include "tests/replay/program.hpp"
#include "tests/support/panel_camera.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace autostereo::test {
namespace {

constexpr const char* kModel = R"(type = "van_berkel"
base = "slanted-8view-1080p"
model = "Small panel"
[panel]
width = 640
height = 400
width_mm = 320
[viewing]
distance_m = 0.7
cone_deg = 28.6
[lens]
subpixels_per_lens = SUBPIXELS
row_shift_subpixels = 0.9
offset_subpixels = OFFSET
)";

std::string modelWith(const std::string& subpixels, const std::string& offset) {
    std::string text = kModel;
    text.replace(text.find("SUBPIXELS"), 9, subpixels);
    text.replace(text.find("OFFSET"), 6, offset);
    return text;
}

std::vector<std::uint8_t> picture(const std::string& file) {
    devices::ImageReader reader;
    const devices::ImageHeader header = reader.open(file);
    std::vector<std::byte> rgba(header.bytes());
    reader.decode(rgba);
    return daemon::withoutAlpha(rgba);
}

class CalibrateDisplay : public testing::Test {
  protected:
    void SetUp() override {
        model = folder.file("model.toml", modelWith("7.6", "0"));
        unit = folder.file("unit.toml", modelWith("7.612", "3.1"));
        config::RigFile rig;
        rig.color = camera.model();
        rig.depth = camera.model();
        rig.colorFromDepth = calib::RigidTransform{};
        rig.provenance = "simulated";
        cameraFile = folder.file("camera.toml", config::rigText(rig));
    }
    /// Four photographs from each of three places, as files, of the unit showing the model's.
    std::vector<std::string> photographs() {
        const auto optics = calib::displayOptics(config::loadDisplay(unit)).value();
        std::vector<std::string> files;
        const std::vector<glm::dvec3> places{
            {-0.06, 0.03, 0.36}, {0.01, -0.04, 0.42}, {0.06, 0.01, 0.38}};
        for (const glm::dvec3& place : places) {
            camera.place(place, 0.02);
            for (const char* name : {"calibration-board", "calibration-fringes-1",
                                     "calibration-fringes-2", "calibration-fringes-3"}) {
                const std::string shown = folder / (std::string(name) + ".png");
                EXPECT_TRUE(succeeded(
                    runProgram(calling({"pattern", name, "--display", model, "--output", shown}))));
                const auto photo = camera.photograph(optics, picture(shown));
                files.push_back(folder / (std::to_string(files.size()) + ".png"));
                const auto& size = camera.model().intrinsics;
                devices::writePng(files.back(),
                                  {{devices::ImageFormat::Rgb8, size.width, size.height},
                                   std::as_bytes(std::span(photo))});
            }
        }
        return files;
    }
    ProgramResult calibrate(const std::vector<std::string>& files, const std::string& display) {
        std::vector<std::string> words{
            "calibrate", "display",  "--display",          display,        "--camera", cameraFile,
            "--json",    "--output", folder / "mine.toml", "--photographs"};
        words.insert(words.end(), files.begin(), files.end());
        return runProgram(calling(words));
    }

    TempFolder folder;
    PanelCamera camera{720, 540, 5};
    std::string model, unit, cameraFile;
};

TEST_F(CalibrateDisplay, PhotographsMakeTheUnitsFile) {
    const auto files = photographs();
    const ProgramResult result = calibrate(files, model);
    ASSERT_TRUE(succeeded(result));
    const auto report = nlohmann::json::parse(result.out);
    EXPECT_NEAR(report["numbers"]["lens.subpixels_per_lens"]["value"].get<double>(), 7.612, 1e-3);
    EXPECT_LT(report["phase_95_views"].get<double>(), 0.5);
    const auto mine = config::loadDisplay(folder / "mine.toml");
    EXPECT_EQ(mine.provenance.at("subpixels_per_lens"), "measured");
    // Any eye sees the same through the file's lenses as through the unit's: the same phases.
    const auto is = calib::displayOptics(mine)->lenses;
    const auto was = calib::displayOptics(config::loadDisplay(unit))->lenses;
    for (const double x : {-0.15, 0.0, 0.15})
        for (const double y : {-0.09, 0.0, 0.09}) {
            const double off =
                is.coordinate({0, 0, 0.7}, {x, y}) - was.coordinate({0, 0, 0.7}, {x, y});
            EXPECT_LT(8 * std::abs(off - std::round(off)), 0.1); // views
        }
    EXPECT_TRUE(succeeded(runProgram(calling({"check", folder / "mine.toml"}))));
}

/// The unit's sheet is bent, by a quarter of a view in its middle; its file gets a grid that says
/// so, the panel is drawn with it, and measuring the flat model again takes it out.
TEST_F(CalibrateDisplay, ABentSheetsGridGoesIntoTheFile) {
    const std::string flat = modelWith("7.612", "3.1");
    unit =
        folder.file("unit.toml", flat + "[phase_grid]\ncolumns = 3\nrows = 3\ncycles = [0, 0, 0, "
                                        "0, 0.06, 0, 0, 0, 0]\n[provenance]\ncycles = "
                                        "\"measured\"\n");
    const ProgramResult result = calibrate(photographs(), model);
    ASSERT_TRUE(succeeded(result));
    const auto report = nlohmann::json::parse(result.out);
    EXPECT_GT(report["deformation_views"].get<double>(), 0.05);
    const std::string mineFile = folder / "mine.toml";
    const auto mine = config::loadDisplay(mineFile);
    EXPECT_EQ(mine.provenance.at("cycles"), "measured");
    const auto is = calib::displayOptics(mine)->lenses;
    const auto was = calib::displayOptics(config::loadDisplay(unit))->lenses;
    const auto error = [&](const calib::LensArray& found, const glm::dvec2& place) {
        const double off =
            found.coordinate({0, 0, 0.7}, place) - was.coordinate({0, 0, 0.7}, place);
        return 8 * std::abs(off - std::round(off)); // views
    };
    auto without = is;
    without.correction = {};
    double worst = 0, worstWithout = 0;
    for (const double x : {-0.15, -0.08, 0.0, 0.08, 0.15})
        for (const double y : {-0.09, -0.05, 0.0, 0.05, 0.09}) {
            worst = std::max(worst, error(is, {x, y}));
            worstWithout = std::max(worstWithout, error(without, {x, y}));
        }
    EXPECT_LT(worst, 0.1);
    EXPECT_GT(worstWithout, 0.15);
    EXPECT_TRUE(succeeded(runProgram(calling({"check", mineFile}))));

    unit = folder.file("unit.toml", flat);
    std::filesystem::copy_file(mineFile, folder / "bent.toml");
    ASSERT_TRUE(succeeded(calibrate(photographs(), folder / "bent.toml")));
    const auto again = config::loadDisplay(mineFile);
    EXPECT_TRUE(calib::phaseGrid(again.law)->cycles.empty());
}

TEST_F(CalibrateDisplay, WhatCannotBeRightIsRefused) {
    auto files = photographs();
    files.pop_back();
    EXPECT_EQ(calibrate(files, model).exitCode, 2);
    std::ranges::fill(files, files.front()); // a board where fringes should be
    files.resize(8, files.front());
    const ProgramResult result = calibrate(files, model);
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_NE(result.err.find("no regular fringes"), std::string::npos) << result.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "mine.toml"));
    EXPECT_EQ(calibrate(files, "preview").exitCode, 2); // no optics
}

} // namespace
} // namespace autostereo::test
