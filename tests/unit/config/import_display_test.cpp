#include "config/load.hpp"
#include "config/looking_glass_json.hpp"
#include "config/text_file.hpp"
#include "config/vendor_calibration.hpp"
#include "tests/support/data.hpp"
#include "tests/unit/config/temp_folder.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <numbers>
#include <string>
#include <vector>

namespace autostereo::config {
namespace {

const std::vector<std::string> kRealUnits{"00297",      "LKG-2K-01338", "LKG-2K-04409",
                                          "LKG-E11076", "LKG-J00133",   "LKG-PORT-05935"};

std::filesystem::path realUnit(const std::string& serial) {
    return test::dataDir() / "lkg-calibrations" / (serial + ".json");
}

/// All numbers equal to the last bit.
void expectSame(const calib::LookingGlassCalibration& a, const calib::LookingGlassCalibration& b) {
    EXPECT_EQ(a.pitch, b.pitch);
    EXPECT_EQ(a.slope, b.slope);
    EXPECT_EQ(a.center, b.center);
    EXPECT_EQ(a.dpi, b.dpi);
    EXPECT_EQ(a.screenWidth, b.screenWidth);
    EXPECT_EQ(a.screenHeight, b.screenHeight);
    EXPECT_EQ(a.flipImageX, b.flipImageX);
    EXPECT_EQ(a.flipImageY, b.flipImageY);
    EXPECT_EQ(a.flipSubpixels, b.flipSubpixels);
    EXPECT_EQ(a.pattern, b.pattern);
    EXPECT_EQ(a.cells, b.cells);
}

class ImportDisplay : public test::TempFolder {};

TEST_F(ImportDisplay, realUnitsReadBackToTheSameDoubles) {
    AUTOSTEREO_NEED_DATA("lkg-calibrations");
    for (const std::string& serial : kRealUnits) {
        SCOPED_TRACE(serial);
        const std::string json = readTextFile(realUnit(serial));
        const LookingGlassUnit unit = readLookingGlassJson("visual.json", json);
        EXPECT_EQ(unit.serial, serial);
        EXPECT_TRUE(unit.warnings.empty());
        const auto imported = importDisplay(Vendor::LookingGlass, "visual.json", json);
        write("mine.toml", imported.toml);
        const auto display = loadDisplay("mine.toml");
        expectSame(std::get<calib::LookingGlassCalibration>(display.law), unit.lens);
        EXPECT_EQ(display.width, unit.lens.screenWidth);
        EXPECT_DOUBLE_EQ(display.coneRad, *unit.viewConeDeg * std::numbers::pi / 180);
        EXPECT_EQ(display.notes.at("serial"), serial);
        EXPECT_EQ(display.provenance.at("pitch"), "per-unit");
        EXPECT_FALSE(display.placeholder);
        EXPECT_EQ(display.order, calib::ViewOrder::LeftToRight);
        EXPECT_EQ(calibrationProblem(json), std::nullopt);

        const auto direct = loadDisplay(realUnit(serial).string());
        EXPECT_EQ(direct.name, serial);
        EXPECT_EQ(direct.model, display.model);
        expectSame(std::get<calib::LookingGlassCalibration>(direct.law), unit.lens);
        EXPECT_EQ(kindOf(realUnit(serial)), FileKind::Display);
    }
}

TEST_F(ImportDisplay, thirdGenerationKeepsItsCells) {
    AUTOSTEREO_NEED_DATA("lkg-calibrations");
    const auto display = loadDisplay(realUnit("LKG-J00133").string());
    const auto& lens = std::get<calib::LookingGlassCalibration>(display.law);
    EXPECT_EQ(lens.center, -0.26516956090927126);
    EXPECT_EQ(lens.pattern, calib::CellPattern::Columns);
    ASSERT_EQ(lens.cells.size(), 2U);
    EXPECT_EQ(lens.cells[1][1][0], 0.2800000011920929);
    EXPECT_EQ(lens.cells[1][2][1], 0.25);
    EXPECT_EQ(display.notes.at("invView"), "0.0");
    EXPECT_EQ(display.notes.at("configVersion"), "3.0");
    EXPECT_EQ(display.views, 49);
    EXPECT_EQ(display.model,
              "Looking Glass 16 inch OLED landscape, third generation, unit LKG-J00133");
}

constexpr const char* kPlain = R"({"serial": "LKG-E0", "pitch": 80, "slope": -6.5, "center": 0,
"DPI": 491, "screenW": 1440, "screenH": 2560.0, "flipImageX": 1})";

TEST_F(ImportDisplay, plainNumbersAndMissingFields) {
    const auto unit = readLookingGlassJson("x.json", kPlain);
    EXPECT_EQ(unit.lens.pitch, 80);
    EXPECT_EQ(unit.lens.screenHeight, 2560);
    EXPECT_TRUE(unit.lens.flipImageX);
    EXPECT_FALSE(unit.lens.flipSubpixels);
    EXPECT_FALSE(unit.viewConeDeg);
    EXPECT_TRUE(unit.lens.cells.empty());
    const auto display = displayFromText("x.json", kPlain);
    EXPECT_EQ(display.provenance.at("cone_deg"), "assumed"); // the model's
    EXPECT_DOUBLE_EQ(display.coneRad, 54 * std::numbers::pi / 180);
}

// A stripe panel stays one, even where its model's shipped display has cells.
TEST_F(ImportDisplay, noCellsOfTheBaseAreTakenOver) {
    const auto display = displayFromText("x.json", test::edited(kPlain, "LKG-E0", "LKG-H0"));
    EXPECT_TRUE(std::get<calib::LookingGlassCalibration>(display.law).cells.empty());
}

TEST_F(ImportDisplay, allModesOfCells) {
    const std::string cell = R"({"ROffsetX":0.1,"ROffsetY":0.2,"GOffsetX":-0.3,"GOffsetY":0,)"
                             R"("BOffsetX":0,"BOffsetY":-0.25})";
    std::string four = cell;
    for (int more = 0; more < 3; ++more)
        four.append(",").append(cell);
    using enum calib::CellPattern;
    const calib::CellPattern patterns[] = {Single, Checkerboard, Columns, Staircase, Rows};
    for (int mode = 0; mode < 5; ++mode)
        for (const char* key : {"CellPatternMode", "cellPatternMode"}) {
            std::string end = ", \"";
            end.append(key).append("\": {\"value\": ").append(std::to_string(mode));
            end.append(".0}, \"subpixelCells\": [").append(four).append("]}");
            const auto display = displayFromText("x.json", test::edited(kPlain, "}", end));
            const auto& lens = std::get<calib::LookingGlassCalibration>(display.law);
            EXPECT_EQ(lens.pattern, patterns[mode]);
            const calib::SubpixelCell expected{{{0.1, 0.2}, {-0.3, 0}, {0, -0.25}}};
            EXPECT_EQ(lens.cells, std::vector(4, expected));
        }
}

TEST_F(ImportDisplay, whatNothingUsesIsKeptAsNotes) {
    const std::string more = R"(, "invView": {"value": 0}, "buttons": [1, {"a": "\"\u0007\\"}],
"\u00e4 key = \"]": null})";
    const auto display = displayFromText("x.json", test::edited(kPlain, "}", more));
    EXPECT_EQ(display.notes.at("invView"), "0");
    EXPECT_EQ(display.notes.at("buttons"), R"([1,{"a":"\"\u0007\\"}])");
    EXPECT_EQ(display.notes.at("ä key = \"]"), "null");
    EXPECT_EQ(display.order, calib::ViewOrder::LeftToRight) << "invView decides nothing";
}

TEST_F(ImportDisplay, unusualNumbersLoadWithAWarning) {
    const std::string json = test::edited(kPlain, "80", "20");
    const auto imported = importDisplay(Vendor::LookingGlass, "x.json", json);
    ASSERT_EQ(imported.warnings.size(), 1U);
    EXPECT_EQ(imported.warnings[0], "pitch = 20 is unusual (known units have 30 to 90)");
    EXPECT_EQ(displayFromText("x.json", json).notes.at("warning"), imported.warnings[0]);
}

TEST_F(ImportDisplay, baseAndViewOrderCanBeChosen) {
    const auto imported = importDisplay(Vendor::LookingGlass, "x.json", kPlain,
                                        {"looking-glass-portrait", calib::ViewOrder::RightToLeft});
    const auto display = displayFromText("x.toml", imported.toml);
    EXPECT_EQ(display.views, 48);
    EXPECT_EQ(display.order, calib::ViewOrder::RightToLeft);
    EXPECT_EQ(display.model, "Looking Glass Portrait 7.9 inch, unit LKG-E0");
    EXPECT_FALSE(display.placeholder);
}

TEST_F(ImportDisplay, baseFollowsTheSerialThenTheSize) {
    const auto base = [](const std::string& serial, int width, int height) {
        const std::string json = R"({"serial": ")" + serial +
                                 R"(", "pitch": 50, "slope": 6, "center": 0, "DPI": 300, )"
                                 R"("flipImageX": 0, "screenW": )" +
                                 std::to_string(width) +
                                 ", \"screenH\": " + std::to_string(height) + '}';
        return importDisplay(Vendor::LookingGlass, "x.json", json).base;
    };
    EXPECT_EQ(base("LKG-PORT-1", 1536, 2048), "looking-glass-portrait-template");
    EXPECT_EQ(base("LKG-J1", 3840, 2160), "looking-glass-16-landscape-gen3");
    EXPECT_EQ(base("LKG-D1", 7680, 4320), "looking-glass-65");
    EXPECT_EQ(base("00112", 2560, 1600), "looking-glass-8.9-gen1");
    EXPECT_EQ(base("", 2880, 5120), "looking-glass-27-portrait-gen3");
}

TEST_F(ImportDisplay, cubevi) {
    const char* kConfig = R"({"lineNumber": 19.6104, "obliquity": -0.1007, "deviation": -1.95,
"deviceId": "C1-7", "x": 1})";
    const std::string nested =
        R"({"id": 3, "response_data": {"config": )" + std::string(kConfig) + "}}";
    for (const std::string& json : {std::string(kConfig), nested}) {
        EXPECT_EQ(vendorOf(json), Vendor::Cubevi);
        const auto display = displayFromText("deviceConfig.json", json);
        const auto& lens = std::get<calib::CubeviCalibration>(display.law);
        EXPECT_EQ(lens.subpixelsPerLens, 19.6104);
        EXPECT_EQ(lens.slope, -0.1007);
        EXPECT_EQ(lens.offsetSubpixels, -1.95);
        EXPECT_EQ(display.model, "CubeVi C1, unit C1-7");
        EXPECT_EQ(display.notes.at("x"), "1");
        EXPECT_FALSE(display.placeholder);
    }
}

TEST_F(ImportDisplay, otherJsonIsNobodys) {
    for (const char* text : {"", "{", "[]", "{}", R"({"depth": {}})", "\xff\xfe"})
        EXPECT_EQ(vendorOf(text), std::nullopt) << text;
}

} // namespace
} // namespace autostereo::config
