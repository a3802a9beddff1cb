#include "config/load.hpp"
#include "tests/unit/config/bad_texts.hpp"
#include "tests/unit/config/temp_folder.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace autostereo::config {
namespace {

constexpr bad::Case kBadDisplays[] = {
    {"empty", bad::kVanBerkel, "", "",
     "x.toml:1:1: type: missing, wanted a word (allowed linear, van_berkel, looking_glass, cubevi, "
     "table, lut, line_screen, two_view_tracked, quilt, 2d_plus_depth, side_by_side, top_bottom, "
     "row, column, checkerboard, anaglyph, flat)"},
    {"onlyComment", bad::kVanBerkel, "", "# nothing",
     "x.toml:1:1: type: missing, wanted a word (allowed linear, van_berkel, looking_glass, cubevi, "
     "table, lut, line_screen, two_view_tracked, quilt, 2d_plus_depth, side_by_side, top_bottom, "
     "row, column, checkerboard, anaglyph, flat)"},
    {"notToml", bad::kVanBerkel, "", "{\"pitch\": 5}",
     "x.toml:1:1: syntax: Error while parsing root table: expected keys, tables, whitespace or "
     "comments, saw '{'"},
    {"binary", bad::kVanBerkel, "", "\177ELF\002\001",
     "x.toml:1:1: syntax: Error while parsing root table: expected keys, tables, whitespace or "
     "comments, saw '\\u007F'"},
    {"invalidUtf8", bad::kVanBerkel, "model = \"bad\"", "model = \"\xff\xfe\"",
     "x.toml:2:9: syntax: Encountered invalid utf-8 sequence"},
    {"unclosedString", bad::kVanBerkel, "model = \"bad\"", "model = \"bad",
     "x.toml:2:13: syntax: Error while parsing string: unescaped control characters other than TAB "
     "(U+0009) are explicitly prohibited"},
    {"duplicateKey", bad::kVanBerkel, "offset_subpixels = 0", "subpixels_per_lens = 0",
     "x.toml:11:22: syntax: Error while parsing key-value pair: cannot redefine existing integer "
     "'subpixels_per_lens'"},
    {"duplicateTable", bad::kVanBerkel, "[provenance]", "[lens]",
     "x.toml:12:1: syntax: Error while parsing table header: cannot redefine existing table "
     "'lens'"},
    {"typeMissing", bad::kVanBerkel, "type = \"van_berkel\"\n", "",
     "x.toml:1:1: type: missing, wanted a word (allowed linear, van_berkel, looking_glass, cubevi, "
     "table, lut, line_screen, two_view_tracked, quilt, 2d_plus_depth, side_by_side, top_bottom, "
     "row, column, checkerboard, anaglyph, flat)"},
    {"typeIsNumber", bad::kVanBerkel, "type = \"van_berkel\"", "type = 5",
     "x.toml:1:8: type: is an integer, wanted a word (allowed linear, van_berkel, looking_glass, "
     "cubevi, table, lut, line_screen, two_view_tracked, quilt, 2d_plus_depth, side_by_side, "
     "top_bottom, row, column, checkerboard, anaglyph, flat)"},
    {"panelIsNumber", bad::kVanBerkel, "panel = { width = 1920, height = 1080, width_mm = 500 }",
     "panel = 5", "x.toml:3:9: panel: is an integer, wanted a table"},
    {"lensMissing", bad::kVanBerkel,
     "[lens]\nsubpixels_per_lens = 8\nrow_shift_subpixels = 1\noffset_subpixels = 0\n", "",
     "x.toml:1:1: lens.offset_subpixels: missing, wanted a number (allowed -1000 to 1000)"},
    {"lensIsArray", bad::kVanBerkel, "[lens]", "[[lens]]",
     "x.toml:8:1: lens: is an array, wanted a table"},
    {"modelMissing", bad::kVanBerkel, "model = \"bad\"\n", "",
     "x.toml:1:1: model: missing, wanted a string"},
    {"provenanceMissing", bad::kVanBerkel, "[provenance]", "[origins]",
     "x.toml:12:2: origins: unknown key"},
    {"provenanceWord", bad::kVanBerkel, "width_mm = \"measured\"", "width_mm = \"vendor\"",
     "x.toml:13:12: provenance.width_mm: \"vendor\" is unknown (allowed per-unit, template, "
     "measured, assumed)"},
    {"provenanceOfNothing", bad::kVanBerkel, "width_mm = \"measured\"",
     "width_mm = \"measured\"\ndpi = \"measured\"", "x.toml:14:1: provenance.dpi: unknown key"},
    {"notesAreNumbers", bad::kVanBerkel, "[provenance]", "[notes]\nserial = 5\n[provenance]",
     "x.toml:13:10: notes.serial: is an integer, wanted a string"},
    {"negativeWidth", bad::kVanBerkel, "width = 1920", "width = -1920",
     "x.toml:3:19: panel.width: -1920 is out of range (allowed 16 to 16384)"},
    {"hugeWidth", bad::kVanBerkel, "width = 1920", "width = 100000",
     "x.toml:3:19: panel.width: 100000 is out of range (allowed 16 to 16384)"},
    {"zeroHeight", bad::kVanBerkel, "height = 1080", "height = 0",
     "x.toml:3:34: panel.height: 0 is out of range (allowed 16 to 16384)"},
    {"widthIsFloat", bad::kVanBerkel, "width = 1920", "width = 1920.0",
     "x.toml:3:19: panel.width: is a floating-point number, wanted an integer (allowed 16 to "
     "16384)"},
    {"hugeInteger", bad::kVanBerkel, "width = 1920", "width = 9223372036854775808",
     "x.toml:3:38: syntax: Error while parsing decimal integer: '9223372036854775808' is not "
     "representable in 64 bits"},
    {"widthNaN", bad::kVanBerkel, "width_mm = 500", "width_mm = nan",
     "x.toml:3:51: panel.width_mm: nan is no finite number (allowed 10 to 20000)"},
    {"widthInf", bad::kVanBerkel, "width_mm = 500", "width_mm = inf",
     "x.toml:3:51: panel.width_mm: inf is no finite number (allowed 10 to 20000)"},
    {"widthNegative", bad::kVanBerkel, "width_mm = 500", "width_mm = -500",
     "x.toml:3:51: panel.width_mm: -500 is out of range (allowed 10 to 20000)"},
    {"overflowingNumber", bad::kVanBerkel, "width_mm = 500", "width_mm = 1e999",
     "x.toml:3:56: syntax: Error while parsing floating-point: '1e999' could not be interpreted as "
     "a value"},
    {"edidNamesIsText", bad::kVanBerkel, "width_mm = 500", "width_mm = 500, edid_names = \"LKG*\"",
     "x.toml:3:69: panel.edid_names: is a string, wanted an array of 1 to 16 strings"},
    {"edidNamesNone", bad::kVanBerkel, "width_mm = 500", "width_mm = 500, edid_names = []",
     "x.toml:3:69: panel.edid_names: has 0 elements, wanted an array of 1 to 16 strings"},
    {"billionViews", bad::kVanBerkel, "views = 8", "views = 1000000000",
     "x.toml:4:54: viewing.views: 1000000000 is out of range (allowed 1 to 1000)"},
    {"noViews", bad::kVanBerkel, "views = 8", "views = 0",
     "x.toml:4:54: viewing.views: 0 is out of range (allowed 1 to 1000)"},
    {"zeroCone", bad::kVanBerkel, "cone_deg = 30", "cone_deg = 0",
     "x.toml:4:42: viewing.cone_deg: 0 is out of range (allowed 1 to 120)"},
    {"distanceNegative", bad::kVanBerkel, "distance_m = 0.7", "distance_m = -0.7",
     "x.toml:4:26: viewing.distance_m: -0.7 is out of range (allowed 0.05 to 100)"},
    {"fanOfOneView", bad::kVanBerkel,
     "views = 8, view_order = \"right_to_left\", fan = \"centres\"",
     "views = 1, view_order = \"right_to_left\", fan = \"edges\"",
     "x.toml:4:93: viewing.fan: \"edges\" needs two views or more (allowed centres)"},
    {"quiltTooSmall", bad::kVanBerkel, "columns = 4", "columns = 3",
     "x.toml:5:31: quilt.rows: leaves too few tiles for 8 views (allowed columns x rows >= views)"},
    {"quiltTooLarge", bad::kVanBerkel, "tile_width = 640", "tile_width = 16384",
     "x.toml:5:47: quilt.tile_width: makes the quilt too wide (allowed columns x tile_width <= "
     "16384)"},
    {"budgetTurned", bad::kVanBerkel, "far = -0.02, near = 0.02", "far = 0.02, near = -0.02",
     "x.toml:6:24: depth_budget.far: 0.02 is out of range (allowed -0.5 to -0.001)"},
    {"remapWord", bad::kVanBerkel, "views = 8", "views = 8, view_remap = [\"left\", \"middle\"]",
     "x.toml:4:70: viewing.view_remap: \"middle\" is no view (allowed left, right, black, \"0\" to "
     "\"7\")"},
    {"remapBeyond", bad::kVanBerkel, "views = 8", "views = 8, view_remap = [\"0\", \"8\"]",
     "x.toml:4:70: viewing.view_remap: \"8\" is no view (allowed left, right, black, \"0\" to "
     "\"7\")"},
    {"remapNegative", bad::kVanBerkel, "views = 8", "views = 8, view_remap = [\"-1\"]",
     "x.toml:4:70: viewing.view_remap: \"-1\" is no view (allowed left, right, black, \"0\" to "
     "\"7\")"},
    {"remapNumber", bad::kVanBerkel, "views = 8", "views = 8, view_remap = [1, 2]",
     "x.toml:4:71: viewing.view_remap: is an integer, wanted an array of 1 to 1000 strings"},
    {"remapEmpty", bad::kVanBerkel, "views = 8", "views = 8, view_remap = []",
     "x.toml:4:70: viewing.view_remap: has 0 elements, wanted an array of 1 to 1000 strings"},
    {"remapHuge", bad::kVanBerkel, "views = 8",
     "views = 8, view_remap = [\"99999999999999999999\"]",
     "x.toml:4:70: viewing.view_remap: \"99999999999999999999\" is no view (allowed left, right, "
     "black, \"0\" to \"7\")"},
    {"baseUnknown", bad::kVanBerkel, "model = ", "base = \"portrait\"\nmodel = ",
     "x.toml:2:8: base: \"portrait\" is no shipped display (did you mean "
     "looking-glass-16-portrait-gen3, looking-glass-27-portrait-gen3, "
     "looking-glass-32-portrait-gen3, looking-glass-portrait, looking-glass-portrait-template?)"},
    {"baseNearly", bad::kVanBerkel, "model = ", "base = \"looking-glass-goo\"\nmodel = ",
     "x.toml:2:8: base: \"looking-glass-goo\" is no shipped display (did you mean "
     "looking-glass-go?)"},
    {"baseIsPath", bad::kVanBerkel, "model = ", "base = \"../default\"\nmodel = ",
     "x.toml:2:8: base: \"../default\" is no shipped display (allowed "},
    {"baseOfOtherType", bad::kVanBerkel, "model = ", "base = \"preview\"\nmodel = ",
     "x.toml:2:8: base: \"preview\" is of type anaglyph (allowed displays of the file's own type)"},
    {"baseIsNumber", bad::kVanBerkel,
     "model = ", "base = 5\nmodel = ", "x.toml:2:8: base: is an integer, wanted a string"},
};

class BadDisplays : public testing::TestWithParam<bad::Case> {};

TEST_P(BadDisplays, SayWhatAndWhere) {
    const bad::Case& tested = GetParam();
    const std::string message = bad::messageOf(test::edited(tested.text, tested.from, tested.to));
    if (std::string_view(tested.message).ends_with("(allowed "))
        EXPECT_EQ(message.substr(0, std::string_view(tested.message).size()), tested.message);
    else
        EXPECT_EQ(message, tested.message);
}

INSTANTIATE_TEST_SUITE_P(Each, BadDisplays, testing::ValuesIn(kBadDisplays),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(BadDisplaysTexts, AreGoodUntouched) {
    for (const char* text : {bad::kVanBerkel, bad::kLinear, bad::kGlass, bad::kCubevi, bad::kTable,
                             bad::kScreen, bad::kTracked, bad::kDepth, bad::kFlat, bad::kQuilt})
        EXPECT_EQ(bad::messageOf(text), "no error") << text;
}

} // namespace
} // namespace autostereo::config
