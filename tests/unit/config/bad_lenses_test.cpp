#include "config/load.hpp"
#include "tests/unit/config/bad_texts.hpp"
#include "tests/unit/config/temp_folder.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace autostereo::config {
namespace {

constexpr bad::Case kBadLenses[] = {
    {"lensOfNothing", bad::kVanBerkel, "subpixels_per_lens = 8", "subpixels_per_lens = 0",
     "x.toml:9:22: lens.subpixels_per_lens: 0 is out of range (allowed 1 to 1000)"},
    {"lensNaN", bad::kVanBerkel, "subpixels_per_lens = 8", "subpixels_per_lens = nan",
     "x.toml:9:22: lens.subpixels_per_lens: nan is no finite number (allowed 1 to 1000)"},
    {"shiftHuge", bad::kVanBerkel, "row_shift_subpixels = 1", "row_shift_subpixels = 1e300",
     "x.toml:10:23: lens.row_shift_subpixels: 1e+300 is out of range (allowed -100 to 100)"},
    {"bgrIsNumber", bad::kVanBerkel, "offset_subpixels = 0", "offset_subpixels = 0\nbgr = 1",
     "x.toml:12:7: lens.bgr: is an integer, wanted true or false"},
    {"gapZero", bad::kVanBerkel, "[provenance]",
     "[optics]\ngap_mm = 0\n[provenance]\ngap_mm = \"measured\"",
     "x.toml:13:10: optics.gap_mm: 0 is out of range (allowed 0.001 to 1000)"},
    {"opticsWord", bad::kVanBerkel, "[provenance]", "[optics]\nkind = \"mirror\"\n[provenance]",
     "x.toml:13:8: optics.kind: \"mirror\" is unknown (allowed lens, slit)"},
    {"phaseGridOfATable", bad::kTable, "[provenance]",
     "[phase_grid]\ncolumns = 2\nrows = 2\ncycles = [0, 0, 0, 0]\n[provenance]",
     "x.toml:10:2: phase_grid: unknown key"},
    {"phaseGridCount", bad::kVanBerkel, "[provenance]",
     "[phase_grid]\ncolumns = 2\nrows = 2\ncycles = [0, 0, 0]\n[provenance]\ncycles = \"measured\"",
     "x.toml:15:10: phase_grid.cycles: has 3 elements, wanted an array of 4 numbers (allowed -1 to "
     "1)"},
    {"gridCount", bad::kLinear, "cycles = [0, 0, 0, 0]", "cycles = [0, 0, 0]",
     "x.toml:16:10: phase_grid.cycles: has 3 elements, wanted an array of 4 numbers (allowed -1 to "
     "1)"},
    {"gridNodes", bad::kLinear, "columns = 2", "columns = 0",
     "x.toml:14:11: phase_grid.columns: 0 is out of range (allowed 1 to 256)"},
    {"gridHuge", bad::kLinear, "columns = 2", "columns = 257",
     "x.toml:14:11: phase_grid.columns: 257 is out of range (allowed 1 to 256)"},
    {"gridNaN", bad::kLinear, "cycles = [0, 0, 0, 0]", "cycles = [0, nan, 0, 0]",
     "x.toml:16:14: phase_grid.cycles: nan is no finite number (allowed -1 to 1)"},
    {"channelOfTwo", bad::kLinear, "channel = [0, 0.1, 0.2]", "channel = [0, 0.1]",
     "x.toml:11:11: lens.channel: has 2 elements, wanted an array of 3 numbers (allowed -100 to "
     "100)"},
    {"cellsTooFew", bad::kLinear, "channel = [0, 0.1, 0.2]",
     "cell_pattern = \"staircase\"\ncells = [[0, 0.1, 0.2], [0, 0.1, 0.2]]",
     "x.toml:12:9: lens.cells: has 2 rows, too few for its cell pattern (allowed at least 4)"},
    {"cellsRagged", bad::kLinear, "channel = [0, 0.1, 0.2]",
     "cell_pattern = \"columns\"\ncells = [[0, 0.1, 0.2], [0, 0.1]]",
     "x.toml:12:25: lens.cells: has a row of 2 elements, wanted rows of equal length, 3"},
    {"cellPatternWord", bad::kLinear, "channel = [0, 0.1, 0.2]",
     "cell_pattern = \"rings\"\ncells = [[0, 0.1, 0.2]]",
     "x.toml:11:16: lens.cell_pattern: \"rings\" is unknown (allowed single, checkerboard, "
     "columns, staircase, rows, four_rows)"},
    {"pitchZero", bad::kGlass, "pitch = 50", "pitch = 0",
     "x.toml:9:9: lens.pitch: 0 is out of range (allowed 1 to 1000)"},
    {"pitchText", bad::kGlass, "pitch = 50", "pitch = \"50\"",
     "x.toml:9:9: lens.pitch: is a string, wanted a number (allowed 1 to 1000)"},
    {"slopeZero", bad::kGlass, "slope = -7", "slope = 0",
     "x.toml:10:9: lens.slope: 0 is out of range (allowed -1000 to -1 and 1 to 1000)"},
    {"slopeTooFlat", bad::kGlass, "slope = -7", "slope = -0.5",
     "x.toml:10:9: lens.slope: -0.5 is out of range (allowed -1000 to -1 and 1 to 1000)"},
    {"dpiNegative", bad::kGlass, "dpi = 300", "dpi = -300",
     "x.toml:12:7: lens.dpi: -300 is out of range (allowed 10 to 2000)"},
    {"glassWidthGiven", bad::kGlass, "height = 1080", "height = 1080, width_mm = 500",
     "x.toml:3:40: panel.width_mm: unknown key"},
    {"glassCellsRow", bad::kGlass, "flip_image_x = false",
     "flip_image_x = false\ncells = [[0, 0, 0]]",
     "x.toml:14:10: lens.cells: has a row of 3 elements, wanted rows of equal length, 6"},
    {"glassCells17", bad::kGlass, "flip_image_x = false",
     "flip_image_x = false\ncells = [[0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], "
     "[0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, "
     "0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, "
     "0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, "
     "0], ]",
     "x.toml:14:9: lens.cells: has 17 elements, wanted an array of 0 to 16 rows of 6 numbers "
     "(allowed -2 to 2)"},
    {"glassPatternAlone", bad::kGlass, "flip_image_x = false",
     "flip_image_x = false\ncell_pattern = \"rows\"",
     "x.toml:14:16: lens.cell_pattern: needs cells (allowed single without)"},
    {"glassCellsTooFew", bad::kGlass, "flip_image_x = false",
     "flip_image_x = false\ncell_pattern = \"rows\"\ncells = [[0, 0, 0, 0, 0, 0]]",
     "x.toml:15:9: lens.cells: has 1 rows, too few for its cell pattern (allowed at least 2)"},
    {"fringeNegative", bad::kGlass, "flip_image_x = false", "flip_image_x = false\nfringe = -1",
     "x.toml:14:10: lens.fringe: -1 is out of range (allowed 0 to 1000)"},
    {"cubeviSlope", bad::kCubevi, "slope = 0.1", "slope = 45",
     "x.toml:10:9: lens.slope: 45 is out of range (allowed -10 to 10)"},
    {"tableRagged", bad::kTable, "[[0, 1, 2], [3, 4, 5]]", "[[0, 1, 2], [3, 4]]",
     "x.toml:9:21: lens.table: has a row of 2 elements, wanted rows of equal length, 1 to 192"},
    {"tableView8", bad::kTable, "[[0, 1, 2], [3, 4, 5]]", "[[0, 1, 8]]",
     "x.toml:9:17: lens.table: 8 is out of range (allowed 0 to 7)"},
    {"tableNegative", bad::kTable, "[[0, 1, 2], [3, 4, 5]]", "[[0, -1, 2]]",
     "x.toml:9:14: lens.table: -1 is out of range (allowed 0 to 7)"},
    {"tableFraction", bad::kTable, "[[0, 1, 2], [3, 4, 5]]", "[[0, 1.5, 2]]",
     "x.toml:9:9: lens.table: 1.5 is no view (allowed whole numbers)"},
    {"tableEmpty", bad::kTable, "[[0, 1, 2], [3, 4, 5]]", "[]",
     "x.toml:9:9: lens.table: has 0 elements, wanted an array of 1 to 64 rows of 1 to 192 numbers "
     "(allowed 0 to 7)"},
    {"tableEmptyRow", bad::kTable, "[[0, 1, 2], [3, 4, 5]]", "[[]]",
     "x.toml:9:10: lens.table: has a row of 0 elements, wanted rows of equal length, 1 to 192"},
    {"tableFlat", bad::kTable, "[[0, 1, 2], [3, 4, 5]]", "[0, 1, 2]",
     "x.toml:9:10: lens.table: is an integer, wanted an array of 1 to 64 rows of 1 to 192 numbers "
     "(allowed 0 to 7)"},
    {"dutyZero", bad::kScreen, "duty_cycle = 0.75", "duty_cycle = 0",
     "x.toml:10:14: barrier.duty_cycle: 0 is out of range (allowed 0.01 to 0.99)"},
    {"dutyOne", bad::kScreen, "duty_cycle = 0.75", "duty_cycle = 1",
     "x.toml:10:14: barrier.duty_cycle: 1 is out of range (allowed 0.01 to 0.99)"},
    {"guardTooSmall", bad::kScreen, "duty_cycle = 0.75", "duty_cycle = 0.75\nguard = -0.75",
     "x.toml:11:9: barrier.guard: leaves nothing dark (allowed > -duty_cycle)"},
    {"guardTooLarge", bad::kScreen, "duty_cycle = 0.75", "duty_cycle = 0.75\nguard = 0.25",
     "x.toml:11:9: barrier.guard: leaves no light (allowed < 1 - duty_cycle)"},
    {"eyeBehindBarrier", bad::kScreen, "duty_cycle = 0.75",
     "duty_cycle = 0.75\neyes_m = [[-0.03, 0, 0.001], [0.03, 0, 0.7]]",
     "x.toml:11:10: barrier.eyes_m: has an eye at z = 0.001 (allowed in front of the barrier)"},
    {"eyesTooFew", bad::kScreen, "duty_cycle = 0.75",
     "duty_cycle = 0.75\neyes_m = [[-0.03, 0, 0.7]]",
     "x.toml:11:10: barrier.eyes_m: has 1 elements, wanted an array of 2 rows of 3 numbers "
     "(allowed -100 to 100)"},
    {"thickerThanDistance", bad::kScreen, "thickness_mm = 5", "thickness_mm = 700",
     "x.toml:11:16: barrier.thickness_mm: reaches the viewer (allowed < viewing.distance_m)"},
    {"waveformOrder", bad::kScreen, "[provenance]",
     "[waveform]\nred = [0, 0.5, 0.4, 1]\ngreen = [0, 0, 1, 1]\nblue = [0, 0, 1, 1]\n[provenance]",
     "x.toml:15:7: waveform.red: is not in order (allowed rise start <= rise end <= fall start <= "
     "fall end)"},
    {"waveformChannelMissing", bad::kScreen, "[provenance]",
     "[waveform]\nred = [0, 0, 1, 1]\ngreen = [0, 0, 1, 1]\n[provenance]",
     "x.toml:14:1: waveform.blue: missing, wanted an array of 4 numbers (allowed 0 to 1)"},
    {"formWord", bad::kScreen, "duty_cycle = 0.75", "duty_cycle = 0.75\nform = \"wave\"",
     "x.toml:11:8: barrier.form: \"wave\" is unknown (allowed exact, paper)"},
    {"screenAngle", bad::kScreen, "angle_deg = 7", "angle_deg = 90",
     "x.toml:12:13: barrier.angle_deg: 90 is out of range (allowed -60 to 60)"},
    {"fillOfWholePeriod", bad::kTracked, "fill_px = 1", "fill_px = 5",
     "x.toml:12:11: lens.fill_px: lights the whole period (allowed < period_px)"},
    {"periodZero", bad::kTracked, "period_px = 5", "period_px = 0",
     "x.toml:9:13: lens.period_px: 0 is out of range (allowed 0.5 to 1000)"},
    {"oddWidth", bad::kDepth, "width = 1920", "width = 1921",
     "x.toml:3:19: panel.width: has to be even and hold the header (allowed 256 to 16384)"},
    {"narrowPanel", bad::kDepth, "width = 1920", "width = 250",
     "x.toml:3:19: panel.width: has to be even and hold the header (allowed 256 to 16384)"},
    {"factorTooLarge", bad::kDepth, "factor = 64", "factor = 256",
     "x.toml:9:10: frame.factor: 256 is out of range (allowed 0 to 255)"},
    {"gainZero", bad::kDepth, "gain = 3000", "gain = 0",
     "x.toml:11:8: frame.gain: 0 is out of range (allowed 1 to 1000000)"},
    {"glassesWord", bad::kFlat, "glasses = \"red-cyan\"", "glasses = \"blue\"",
     "x.toml:3:11: glasses: \"blue\" is unknown (allowed red-cyan, green-magenta, amber-blue)"},
    {"heightZeroAlone", bad::kFlat, "height = 1080", "height = 0",
     "x.toml:4:34: panel.height: must be 0 where width is, and only there"},
    {"swapEyesWord", bad::kFlat, "glasses = \"red-cyan\"", "swap_eyes = \"yes\"",
     "x.toml:3:13: swap_eyes: is a string, wanted true or false"},
    {"viewsOfAnaglyph", bad::kFlat, "cone_deg = 30", "cone_deg = 30, views = 2",
     "x.toml:5:46: viewing.views: unknown key"},
    {"flatHasNoLens", bad::kFlat, "[provenance]", "[lens]\npitch = 5\n[provenance]",
     "x.toml:8:2: lens: unknown key"},
    {"quiltViews", bad::kQuilt, "views = 8", "views = 9",
     "x.toml:5:31: quilt.rows: leaves too few tiles for 9 views (allowed columns x rows >= views)"},
};

class BadLenses : public testing::TestWithParam<bad::Case> {};

TEST_P(BadLenses, SayWhatAndWhere) {
    const bad::Case& tested = GetParam();
    EXPECT_EQ(bad::messageOf(test::edited(tested.text, tested.from, tested.to)), tested.message);
}

INSTANTIATE_TEST_SUITE_P(Each, BadLenses, testing::ValuesIn(kBadLenses),
                         [](const auto& tested) { return std::string(tested.param.name); });

} // namespace
} // namespace autostereo::config
