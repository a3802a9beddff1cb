#include "config/load.hpp"
#include "config/looking_glass_json.hpp"
#include "config/vendor_calibration.hpp"
#include "tests/unit/config/temp_folder.hpp"

#include <gtest/gtest.h>

#include <string>

namespace autostereo::config {
namespace {

constexpr const char* kGood =
    R"({"serial": "LKG-E0", "pitch": {"value": 80.7}, "slope": {"value": -6.3},
"center": {"value": 0.5}, "viewCone": {"value": 54}, "DPI": {"value": 491},
"screenW": {"value": 1440}, "screenH": {"value": 2560}, "flipImageX": {"value": 0}})";
constexpr const char* kCell =
    R"({"ROffsetX": 0, "ROffsetY": 0, "GOffsetX": 0, "GOffsetY": 0, "BOffsetX": 0, "BOffsetY": 0})";

constexpr const char* kCubevi =
    R"({"config": {"lineNumber": 19.6, "obliquity": 0.1057, "deviation": 8.89}})";

struct Bad {
    const char* name;
    const char* from; ///< "": all of it
    const char* to;
    const char* message;
};

constexpr Bad kLookingGlass[] = {
    {"empty", R"()", R"()",
     "x.json:1:1: is no JSON: syntax error while parsing value - unexpected end of input; expected "
     "'[', '{', or a literal"},
    {"notJson", R"()", R"(pitch = 5)",
     "x.json:1:1: is no JSON: syntax error while parsing value - invalid literal; last read: 'p'"},
    {"binary", R"()", "\177ELF",
     "x.json:1:1: is no JSON: syntax error while parsing value - invalid literal; last read: '?'"},
    {"truncated", R"( "flipImageX": {"value": 0}})", R"()",
     "x.json:3:56: is no JSON: syntax error while parsing object key - unexpected end of input; "
     "expected string literal"},
    {"truncatedInKey", R"()", R"({"serial": "LKG-E0", "pit)",
     "x.json:1:26: is no JSON: syntax error while parsing object key - invalid string: missing "
     "closing quote; last read: '\"pit'; expected string literal"},
    {"array", R"()", R"([1, 2])", "x.json: is an array, wanted a JSON object"},
    {"justNumber", R"()", R"(5)", "x.json: is a number, wanted a JSON object"},
    {"null", R"()", R"(null)", "x.json: is null, wanted a JSON object"},
    {"emptyObject", R"()", R"({})", "x.json: pitch: missing, wanted a number (allowed 1 to 1000)"},
    {"trailing", R"("flipImageX": {"value": 0}})", R"("flipImageX": {"value": 0}} x)",
     "x.json:3:85: is no JSON: syntax error while parsing value - invalid literal; last read: '0}} "
     "x'; expected end of input"},
    {"invalidUtf8", R"(LKG-E0)", "\xff\xfe",
     "x.json:1:13: is no JSON: syntax error while parsing value - invalid string: ill-formed UTF-8 "
     "byte; last read: '\"\377'"},
    {"nanWord", R"("value": 80.7)", R"("value": NaN)",
     "x.json:1:41: is no JSON: syntax error while parsing value - invalid literal; last read: "
     "'\"value\": N'"},
    {"infinityWord", R"("value": 80.7)", R"("value": Infinity)",
     "x.json:1:41: is no JSON: syntax error while parsing value - invalid literal; last read: "
     "'\"value\": I'"},
    {"overflow", R"("value": 80.7)", R"("value": 1e999)",
     "x.json: is no JSON: number overflow parsing '1e999'"},
    {"allZeros", R"()",
     R"({"serial": "LKG-E0", "pitch": {"value": 0}, "slope": {"value": 0}, "center": {"value": 0}, "viewCone": {"value": 0}, "DPI": {"value": 0}, "screenW": {"value": 0}, "screenH": {"value": 0}, "flipImageX": {"value": 0}})",
     "x.json: pitch: 0, and so is every number: the display served no calibration (unplug its USB "
     "cable and plug it in again)"},
    {"pitchMissing", R"("pitch": {"value": 80.7}, )", R"()",
     "x.json: pitch: missing, wanted a number (allowed 1 to 1000)"},
    {"pitchZero", R"(80.7)", R"(0)", "x.json: pitch: 0 is out of range (allowed 1 to 1000)"},
    {"pitchHuge", R"(80.7)", R"(1e300)",
     "x.json: pitch: 1e+300 is out of range (allowed 1 to 1000)"},
    {"pitchNegative", R"(80.7)", R"(-80.7)",
     "x.json: pitch: -80.7 is out of range (allowed 1 to 1000)"},
    {"pitchText", R"({"value": 80.7})", R"("80.7")",
     "x.json: pitch: is a string, wanted a number (allowed 1 to 1000)"},
    {"pitchTextInside", R"(80.7)", R"("80.7")",
     "x.json: pitch: is a string, wanted a number (allowed 1 to 1000)"},
    {"pitchNull", R"(80.7)", R"(null)",
     "x.json: pitch: is null, wanted a number (allowed 1 to 1000)"},
    {"pitchArray", R"({"value": 80.7})", R"([80.7])",
     "x.json: pitch: is an array, wanted a number (allowed 1 to 1000)"},
    {"pitchNested", R"({"value": 80.7})", R"({"value": {"value": 80.7}})",
     "x.json: pitch: is an object, wanted a number (allowed 1 to 1000)"},
    {"pitchWithoutValue", R"({"value": 80.7})", R"({"val": 80.7})",
     "x.json: pitch: is an object, wanted a number (allowed 1 to 1000)"},
    {"slopeZero", R"(-6.3)", R"(0)",
     "x.json: slope: 0 is out of range (allowed -1000 to -1 and 1 to 1000)"},
    {"slopeTooFlat", R"(-6.3)", R"(0.5)",
     "x.json: slope: 0.5 is out of range (allowed -1000 to -1 and 1 to 1000)"},
    {"slopeMissing", R"("slope": {"value": -6.3},)", R"()",
     "x.json: slope: missing, wanted a number (allowed -1000 to 1000)"},
    {"centerHuge", R"("value": 0.5)", R"("value": 1e9)",
     "x.json: center: 1000000000 is out of range (allowed -100 to 100)"},
    {"coneZero", R"(54)", R"(0)", "x.json: viewCone: 0 is out of range (allowed 1 to 120)"},
    {"coneText", R"(54)", R"("wide")",
     "x.json: viewCone: is a string, wanted a number (allowed 1 to 120)"},
    {"dpiZero", R"(491)", R"(0)", "x.json: DPI: 0 is out of range (allowed 10 to 2000)"},
    {"dpiHuge", R"(491)", R"(100000)", "x.json: DPI: 100000 is out of range (allowed 10 to 2000)"},
    {"widthNegative", R"(1440)", R"(-1440)",
     "x.json: screenW: -1440 is out of range (allowed 16 to 16384)"},
    {"widthFraction", R"(1440)", R"(1440.5)",
     "x.json: screenW: 1440.5 is no whole number (allowed 16 to 16384)"},
    {"heightZero", R"(2560)", R"(0)", "x.json: screenH: 0 is out of range (allowed 16 to 16384)"},
    {"heightHuge", R"(2560)", R"(1e12)",
     "x.json: screenH: 1e+12 is out of range (allowed 16 to 16384)"},
    {"flipMissing", R"(, "flipImageX": {"value": 0}})", R"(})",
     "x.json: flipImageX: missing, wanted a number (allowed 0 to 1)"},
    {"flipTwo", R"("flipImageX": {"value": 0}})", R"("flipImageX": {"value": 2}})",
     "x.json: flipImageX: 2 is out of range (allowed 0 to 1)"},
    {"flipText", R"("flipImageX": {"value": 0}})", R"("flipImageX": "no"})",
     "x.json: flipImageX: is a string, wanted a number (allowed 0 to 1)"},
    {"flipSubpText", R"("flipImageX": {"value": 0}})",
     R"("flipImageX": {"value": 0}, "flipSubp": "RGB"})",
     "x.json: flipSubp: is a string, wanted a number (allowed 0 to 1)"},
    {"fringeNegative", R"("flipImageX": {"value": 0}})",
     R"("flipImageX": {"value": 0}, "fringe": -1})",
     "x.json: fringe: -1 is out of range (allowed 0 to 1000)"},
    {"serialNumber", R"("LKG-E0")", R"(5)", "x.json: serial: is a number, wanted a string"},
    {"modeUnknown", R"("flipImageX": {"value": 0}})",
     R"("flipImageX": {"value": 0}, "CellPatternMode": {"value": 5}})",
     "x.json: CellPatternMode: 5 is out of range (allowed 0 to 4)"},
    {"modeFraction", R"("flipImageX": {"value": 0}})",
     R"("flipImageX": {"value": 0}, "CellPatternMode": 1.5})",
     "x.json: CellPatternMode: 1.5 is no whole number (allowed 0 to 4)"},
    {"modeText", R"("flipImageX": {"value": 0}})",
     R"("flipImageX": {"value": 0}, "cellPatternMode": "rows"})",
     "x.json: cellPatternMode: is a string, wanted a number (allowed 0 to 4)"},
    {"cellsObject", R"("flipImageX": {"value": 0}})",
     R"("flipImageX": {"value": 0}, "subpixelCells": {}})",
     "x.json: subpixelCells: is an object, wanted an array of 0 to 16 objects"},
    {"cellsNumbers", R"("flipImageX": {"value": 0}})",
     R"("flipImageX": {"value": 0}, "subpixelCells": [1, 2]})",
     "x.json: subpixelCells[0]: is a number, wanted an object"},
    {"cells17", R"("flipImageX": {"value": 0}})",
     R"("flipImageX": {"value": 0}, "subpixelCells": [{"ROffsetX": 0, "ROffsetY": 0, "GOffsetX": 0, "GOffsetY": 0, "BOffsetX": 0, "BOffsetY": 0}, {"ROffsetX": 0, "ROffsetY": 0, "GOffsetX": 0, "GOffsetY": 0, "BOffsetX": 0, "BOffsetY": 0}, {"ROffsetX": 0, "ROffsetY": 0, "GOffsetX": 0, "GOffsetY": 0, "BOffsetX": 0, "BOffsetY": 0}, {"ROffsetX": 0, "ROffsetY": 0, "GOffsetX": 0, "GOffsetY": 0, "BOffsetX": 0, "BOffsetY": 0}, {"ROffsetX": 0, "ROffsetY": 0, "GOffsetX": 0, "GOffsetY": 0, "BOffsetX": 0, "BOffsetY": 0}, {"ROffsetX": 0, "ROffsetY": 0, "GOffsetX": 0, "GOffsetY": 0, "BOffsetX": 0, "BOffsetY": 0}, {"ROffsetX": 0, "ROffsetY": 0, "GOffsetX": 0, "GOffsetY": 0, "BOffsetX": 0, "BOffsetY": 0}, {"ROffsetX": 0, "ROffsetY": 0, "GOffsetX": 0, "GOffsetY": 0, "BOffsetX": 0, "BOffsetY": 0}, {"ROffsetX": 0, "ROffsetY": 0, "GOffsetX": 0, "GOffsetY": 0, "BOffsetX": 0, "BOffsetY": 0}, {"ROffsetX": 0, "ROffsetY": 0, "GOffsetX": 0, "GOffsetY": 0, "BOffsetX": 0, "BOffsetY": 0}, {"ROffsetX": 0, "ROffsetY": 0, "GOffsetX": 0, "GOffsetY": 0, "BOffsetX": 0, "BOffsetY": 0}, {"ROffsetX": 0, "ROffsetY": 0, "GOffsetX": 0, "GOffsetY": 0, "BOffsetX": 0, "BOffsetY": 0}, {"ROffsetX": 0, "ROffsetY": 0, "GOffsetX": 0, "GOffsetY": 0, "BOffsetX": 0, "BOffsetY": 0}, {"ROffsetX": 0, "ROffsetY": 0, "GOffsetX": 0, "GOffsetY": 0, "BOffsetX": 0, "BOffsetY": 0}, {"ROffsetX": 0, "ROffsetY": 0, "GOffsetX": 0, "GOffsetY": 0, "BOffsetX": 0, "BOffsetY": 0}, {"ROffsetX": 0, "ROffsetY": 0, "GOffsetX": 0, "GOffsetY": 0, "BOffsetX": 0, "BOffsetY": 0}, {"ROffsetX": 0, "ROffsetY": 0, "GOffsetX": 0, "GOffsetY": 0, "BOffsetX": 0, "BOffsetY": 0}]})",
     "x.json: subpixelCells: has 17 elements, wanted an array of 0 to 16 objects"},
    {"cellsTooFew", R"("flipImageX": {"value": 0}})",
     R"("flipImageX": {"value": 0}, "CellPatternMode": 2, "subpixelCells": [{"ROffsetX": 0, "ROffsetY": 0, "GOffsetX": 0, "GOffsetY": 0, "BOffsetX": 0, "BOffsetY": 0}]})",
     "x.json: subpixelCells: has 1 rows, too few for its cell pattern (allowed at least 2)"},
    {"cellKeyMissing", R"("flipImageX": {"value": 0}})",
     R"("flipImageX": {"value": 0}, "subpixelCells": [{"ROffsetX": 0, "ROffsetY": 0, "GOffsetX": 0, "BOffsetX": 0, "BOffsetY": 0}]})",
     "x.json: subpixelCells[0].GOffsetY: missing, wanted a number (allowed -2 to 2)"},
    {"cellOffsetHuge", R"("flipImageX": {"value": 0}})",
     R"("flipImageX": {"value": 0}, "subpixelCells": [{"ROffsetX": 0, "ROffsetY": 0, "GOffsetX": 0, "GOffsetY": 0, "BOffsetX": 0, "BOffsetY": 0}, {"ROffsetX": 0, "ROffsetY": 0, "GOffsetX": 0, "GOffsetY": 0, "BOffsetX": 0, "BOffsetY": 3}]})",
     "x.json: subpixelCells[1].BOffsetY: 3 is out of range (allowed -2 to 2)"},
    {"noModelOfItsSize", R"()",
     R"({"serial": "7", "pitch": {"value": 80.7}, "slope": {"value": -6.3}, "center": {"value": 0.5}, "viewCone": {"value": 54}, "DPI": {"value": 491}, "screenW": {"value": 1441}, "screenH": {"value": 2560}, "flipImageX": {"value": 0}})", "x.json: screenW: no model is known of 1441x2560, nor a serial of \"7\" (name a display to build on with --base)"},
};

constexpr Bad kCubeviCases[] = {
    {"cubeviMissing", R"("deviation": 8.89)", R"("deviations": 8.89)",
     "x.json: config.deviation: missing, wanted a number (allowed -1000 to 1000)"},
    {"cubeviText", R"(19.6)", R"("19.6")",
     "x.json: config.lineNumber: is a string, wanted a number (allowed 1 to 1000)"},
    {"cubeviLens", R"(19.6)", R"(0)",
     "x.json: config.lineNumber: 0 is out of range (allowed 1 to 1000)"},
    {"cubeviSlope", R"(0.1057)", R"(45)",
     "x.json: config.obliquity: 45 is out of range (allowed -10 to 10)"},
    {"cubeviNested", R"("obliquity": 0.1057)", R"("obliquity": {"x": 1})",
     "x.json: config.obliquity: is an object, wanted a number (allowed -10 to 10)"},
};

class BadCalibrations : public testing::TestWithParam<Bad> {};
class BadCubeviCalibrations : public testing::TestWithParam<Bad> {};

std::string messageOf(Vendor vendor, const std::string& json) {
    return test::messageOf<ConfigError>([&] { (void)importDisplay(vendor, "x.json", json); });
}

TEST_P(BadCalibrations, SayWhatAndWhere) {
    const Bad& bad = GetParam();
    const std::string json = test::edited(kGood, bad.from, bad.to);
    EXPECT_EQ(messageOf(Vendor::LookingGlass, json), bad.message);
    EXPECT_EQ(test::messageOf<ConfigError>([&] { (void)displayFromText("x.json", json); }),
              bad.message);
}

TEST_P(BadCubeviCalibrations, SayWhatAndWhere) {
    const Bad& bad = GetParam();
    EXPECT_EQ(messageOf(Vendor::Cubevi, test::edited(kCubevi, bad.from, bad.to)), bad.message);
}

const auto nameOf = [](const auto& tested) { return std::string(tested.param.name); };
INSTANTIATE_TEST_SUITE_P(Each, BadCalibrations, testing::ValuesIn(kLookingGlass), nameOf);
INSTANTIATE_TEST_SUITE_P(Each, BadCubeviCalibrations, testing::ValuesIn(kCubeviCases), nameOf);

TEST(BadCalibrationsTexts, AreGoodUntouched) {
    EXPECT_EQ(messageOf(Vendor::LookingGlass, kGood), "no error");
    EXPECT_EQ(messageOf(Vendor::Cubevi, kCubevi), "no error");
}

// For the cache: the same words without a file.
TEST(CalibrationProblem, NamesNoFile) {
    EXPECT_EQ(calibrationProblem(kGood), std::nullopt);
    EXPECT_EQ(calibrationProblem("{}"), "pitch: missing, wanted a number (allowed 1 to 1000)");
    EXPECT_EQ(calibrationProblem(test::edited(kGood, "491", "0")),
              "DPI: 0 is out of range (allowed 10 to 2000)");
}

TEST(BadCalibrationsLimits, DeepAndLongTextsAreRefused) {
    const auto wrapped = [](std::size_t levels) {
        return test::edited(kGood, "\"LKG-E0\"",
                            "\"LKG-E0\", \"x\": " + std::string(levels, '[') +
                                std::string(levels, ']'));
    };
    EXPECT_EQ(messageOf(Vendor::LookingGlass, wrapped(15)), "no error");
    EXPECT_EQ(messageOf(Vendor::LookingGlass, wrapped(100'000)),
              "x.json: is nested too deeply (allowed 16 levels)");
    EXPECT_EQ(messageOf(Vendor::LookingGlass, std::string(2 << 20, ' ')),
              "x.json: is longer than 1 MiB");
    EXPECT_EQ(messageOf(Vendor::LookingGlass, std::string(kGood) + std::string(1 << 19, ' ')),
              "no error");
}

// A key of the file that nothing knows is kept, whatever it is called; too many are left out.
TEST(BadCalibrationsLimits, ForeignKeysCannotFloodTheFile) {
    std::string many;
    for (int i = 0; i < 1000; ++i)
        many += "\"k" + std::to_string(i) + "\": \"" + std::string(500, 'x') + "\", ";
    const auto display =
        displayFromText("x.json", test::edited(kGood, "\"serial\"", many + "\"serial\""));
    EXPECT_LE(display.notes.size(), 70U);
    for (const auto& [key, value] : display.notes)
        EXPECT_LE(value.size(), 203U);
}

class BadCalibrationFiles : public test::TempFolder {};

TEST_F(BadCalibrationFiles, SayWhyTheyCannotBeRead) {
    const auto message = [](const char* file) {
        return test::messageOf<ConfigError>([&] { (void)loadDisplay(file); });
    };
    std::filesystem::create_directory("folder.json");
    std::filesystem::create_directory("folder.toml");
    write("long.json", std::string(2 << 20, ' '));
    write("long.toml", std::string(2 << 20, ' '));
    EXPECT_EQ(message("none.json"), "none.json: cannot be read: No such file or directory");
    EXPECT_EQ(message("folder.json"), "folder.json: cannot be read: Is a directory");
    EXPECT_EQ(message("folder.toml"), "folder.toml: cannot be read: Is a directory");
    EXPECT_EQ(message("long.json"), "long.json: cannot be read: it is longer than 1 MiB");
    EXPECT_EQ(message("long.toml"), "long.toml: cannot be read: it is longer than 1 MiB");
    EXPECT_EQ(message("/dev/zero.json"),
              "/dev/zero.json: cannot be read: No such file or directory");
}

} // namespace
} // namespace autostereo::config
