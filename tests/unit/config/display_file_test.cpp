#include "config/load.hpp"
#include "tests/unit/config/temp_folder.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <string>

namespace autostereo::config {
namespace {

class DisplayFile : public test::TempFolder {};

constexpr const char* kDisplay = R"(type = "linear"
model = "test"
[panel]
width = 1920
height = 1080
width_mm = 500
[viewing]
distance_m = 0.75
cone_deg = 30
views = 9
view_order = "right_to_left"
fan = "edges"
[lens]
per_column = 0.25
per_row = -0.125
channel = [0.0, 0.0625, 0.125]
offset = 0.5
[quilt]
columns = 3
rows = 3
tile_width = 640
tile_height = 360
[depth_budget]
far = -0.02
near = 0.03
[provenance]
width_mm = "measured"
distance_m = "measured"
cone_deg = "measured"
per_column = "per-unit"
per_row = "per-unit"
channel = "per-unit"
offset = "measured"
)";

/// kDisplay with one more line under [lens].
std::string withLens(const std::string& line) {
    std::string text = kDisplay;
    text.insert(text.find("[quilt]"), line + "\n");
    return text;
}

TEST_F(DisplayFile, bgrSwapsOuterChannels) {
    write("mine.toml", withLens("bgr = true"));
    const auto phase = std::get<calib::LinearPhase>(loadDisplay("mine.toml").law);
    EXPECT_EQ(phase.channels, (std::vector{std::array{0.125, 0.0625, 0.0}}));
    EXPECT_EQ(phase.perColumn, 0.25);
}

TEST_F(DisplayFile, mirrorTurnsEveryPhaseRound) {
    write("mine.toml", withLens("mirror = true"));
    const auto phase = std::get<calib::LinearPhase>(loadDisplay("mine.toml").law);
    EXPECT_EQ(phase.perColumn, -0.25);
    EXPECT_EQ(phase.perRow, 0.125);
    EXPECT_EQ(phase.offset, -0.5);
    EXPECT_EQ(phase.channels, (std::vector{std::array{-0.0, -0.0625, -0.125}}));
}

TEST_F(DisplayFile, linearTakesCyclesAsTheyAre) {
    write("mine.toml", kDisplay);
    const calib::DisplayProfile display = loadDisplay("mine.toml");
    EXPECT_EQ(display.name, "mine");
    EXPECT_EQ(display.type, "linear");
    const auto& phase = std::get<calib::LinearPhase>(display.law);
    EXPECT_EQ(phase.perColumn, 0.25);
    EXPECT_EQ(phase.perRow, -0.125);
    EXPECT_EQ(phase.channels, (std::vector{std::array{0.0, 0.0625, 0.125}}));
    EXPECT_EQ(phase.offset, 0.5);
    EXPECT_EQ(display.fan, calib::Fan::Edges);
    EXPECT_EQ(display.disparityFar, -0.02);
    EXPECT_EQ(display.disparityNear, 0.03);
    EXPECT_EQ(display.quilt.tileHeight, 360);
    EXPECT_EQ(display.provenance.size(), 7U);
    EXPECT_FALSE(display.placeholder);
}

// No physical number has a default: without any one of them the file does not load.
TEST_F(DisplayFile, everyLineOfTheFileIsNeeded) {
    const std::string whole = kDisplay;
    for (std::size_t start = 0; start < whole.size();) {
        const std::size_t end = whole.find('\n', start) + 1;
        const std::string line = whole.substr(start, end - start);
        write("x.toml", std::string(whole).erase(start, end - start));
        EXPECT_THROW((void)loadDisplay("x.toml"), ConfigError) << "without " << line;
        start = end;
    }
}

struct MalformedDisplay {
    const char* from;
    const char* to;
    const char* message;
};

constexpr MalformedDisplay kMalformedDisplays[] = {
    {"", "",
     "x.toml:1:1: type: missing, wanted a word (allowed linear, van_berkel, "
     "looking_glass, cubevi, table, lut, line_screen, two_view_tracked, quilt, 2d_plus_depth, "
     "side_by_side, top_bottom, row, column, checkerboard, anaglyph, flat)"},
    {"linear", "lenticular",
     "x.toml:1:8: type: \"lenticular\" is unknown (allowed linear, van_berkel, "
     "looking_glass, cubevi, table, lut, line_screen, two_view_tracked, quilt, 2d_plus_depth, "
     "side_by_side, top_bottom, row, column, checkerboard, anaglyph, flat)"},
    {"per_column =", "per_colum =",
     "x.toml:14:1: lens.per_colum: unknown key (did you mean per_column?)"},
    {"[lens]", "[lense]", "x.toml:13:2: lense: unknown key (did you mean lens?)"},
    {"per_column = 0.25\n", "",
     "x.toml:13:1: lens.per_column: missing, wanted a number (allowed -100 to 100)"},
    {"per_row = -0.125", "per_row = \"-1/8\"",
     "x.toml:15:11: lens.per_row: is a string, wanted a number (allowed -100 to "
     "100)"},
    {"offset = 0.5", "offset = nan",
     "x.toml:17:10: lens.offset: nan is no finite number (allowed -100 to 100)"},
    {"offset = 0.5", "offset = -inf",
     "x.toml:17:10: lens.offset: -inf is no finite number (allowed -100 to 100)"},
    {"0.0625, 0.125]", "0.0625]",
     "x.toml:16:11: lens.channel: has 2 elements, wanted an array of 3 numbers "
     "(allowed -100 to 100)"},
    {"0.0625, 0.125]", "0.0625, true]",
     "x.toml:16:25: lens.channel: is a boolean, wanted a number (allowed -100 to "
     "100)"},
    {"width = 1920", "width = -1920",
     "x.toml:4:9: panel.width: -1920 is out of range (allowed 16 to 16384)"},
    {"width = 1920", "width = 0",
     "x.toml:4:9: panel.width: 0 is out of range (allowed 16 to 16384)"},
    {"width = 1920", "width = 1920.5",
     "x.toml:4:9: panel.width: is a floating-point number, wanted an integer "
     "(allowed 16 to 16384)"},
    {"width_mm = 500\n", "",
     "x.toml:3:1: panel.width_mm: missing, wanted a number (allowed 10 to 20000)"},
    {"width_mm = 500\n", "width_m = 0.5\n",
     "x.toml:6:1: panel.width_m: unknown key (did you mean width_mm?)"},
    {"views = 9", "views = 1000000000",
     "x.toml:10:9: viewing.views: 1000000000 is out of range (allowed 1 to 1000)"},
    {"views = 9", "views = 99999999999999999999",
     "x.toml:10:29: syntax: Error while parsing decimal integer: "
     "'99999999999999999999' is not representable in 64 bits"},
    {"views = 9", "views = 10",
     "x.toml:20:8: quilt.rows: leaves too few tiles for 10 views (allowed columns x "
     "rows >= views)"},
    {"views = 9", "views = 1",
     "x.toml:12:7: viewing.fan: \"edges\" needs two views or more (allowed centres)"},
    {"cone_deg = 30", "cone_deg = 180",
     "x.toml:9:12: viewing.cone_deg: 180 is out of range (allowed 1 to 120)"},
    {"right_to_left", "backwards",
     "x.toml:11:14: viewing.view_order: \"backwards\" is unknown (allowed "
     "left_to_right, right_to_left)"},
    {"tile_width = 640", "tile_width = 8000",
     "x.toml:21:14: quilt.tile_width: makes the quilt too wide (allowed columns x "
     "tile_width <= 16384)"},
    {"tile_height = 360", "tile_height = 6000",
     "x.toml:22:15: quilt.tile_height: makes the quilt too high (allowed rows x "
     "tile_height <= 16384)"},
    {"far = -0.02", "far = 0.02",
     "x.toml:24:7: depth_budget.far: 0.02 is out of range (allowed -0.5 to -0.001)"},
    {"per_row = \"per-unit\"\n", "",
     "x.toml:26:1: provenance.per_row: missing, wanted a word (allowed per-unit, "
     "template, measured, assumed)"},
    {"offset = \"measured\"", "offset = \"guessed\"",
     "x.toml:33:10: provenance.offset: \"guessed\" is unknown (allowed per-unit, "
     "template, measured, assumed)"},
    {"offset = \"measured\"", "offset = \"measured\"\npitch = \"measured\"",
     "x.toml:34:1: provenance.pitch: unknown key"},
    {"height = 1080", "width = 1080",
     "x.toml:5:9: syntax: Error while parsing key-value pair: cannot redefine "
     "existing integer 'width'"},
    {"distance_m = 0.75", "distance_m = ",
     "x.toml:8:14: syntax: Error while parsing key-value pair: expected value, saw "
     "'\\n'"},
    {"", "\x89PNG\r\n\x1a\n", "x.toml:1:1: syntax: Encountered invalid utf-8 sequence"}};

TEST_F(DisplayFile, malformedSaysWhatAndWhere) {
    for (const MalformedDisplay& bad : kMalformedDisplays) {
        write("x.toml", test::edited(kDisplay, bad.from, bad.to));
        EXPECT_EQ(test::messageOf<ConfigError>([] { (void)loadDisplay("x.toml"); }), bad.message);
    }
}

constexpr const char* kLookingGlassLens = R"([lens]
pitch = 52.5
slope = -7.1
center = 0.5
dpi = 324
flip_image_x = false
)";

constexpr MalformedDisplay kMalformedLens[] = {
    {"pitch = 52.5", "pitch = 0", "x.toml:3:9: lens.pitch: 0 is out of range (allowed 1 to 1000)"},
    {"pitch = 52.5", "pich = 52.5", "x.toml:3:1: lens.pich: unknown key (did you mean pitch?)"},
    {"slope = -7.1", "slope = 0",
     "x.toml:4:9: lens.slope: 0 is out of range (allowed -1000 to -1 and 1 to "
     "1000)"},
    {"dpi = 324", "dpi = 324e9",
     "x.toml:6:7: lens.dpi: 3.24e+11 is out of range (allowed 10 to 2000)"},
    {"flip_image_x = false", "flip_image_x = 0",
     "x.toml:7:16: lens.flip_image_x: is an integer, wanted true or false"}};

TEST_F(DisplayFile, malformedLensSaysWhatAndWhere) {
    for (const MalformedDisplay& bad : kMalformedLens) {
        const std::string lens = test::edited(kLookingGlassLens, bad.from, bad.to);
        write("x.toml", "type = \"looking_glass\"\n" + lens);
        EXPECT_EQ(test::messageOf<ConfigError>([] { (void)loadDisplay("x.toml"); }), bad.message);
    }
}

} // namespace
} // namespace autostereo::config
