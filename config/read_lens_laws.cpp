#include "config/display_reader.hpp"
#include "config/looking_glass_json.hpp"
#include "config/phrases.hpp"
#include "config/units.hpp"

#include <cmath>
#include <numbers>

namespace autostereo::config {

namespace {

constexpr Range kCycles{-100, 100};

calib::CellPattern readPattern(TomlReader& lens) {
    using calib::CellPattern;
    return lens.choice<CellPattern>("cell_pattern",
                                    {{"single", CellPattern::Single},
                                     {"checkerboard", CellPattern::Checkerboard},
                                     {"columns", CellPattern::Columns},
                                     {"staircase", CellPattern::Staircase},
                                     {"rows", CellPattern::Rows},
                                     {"four_rows", CellPattern::FourRows}},
                                    CellPattern::Single);
}

void requireCells(TomlReader& lens, calib::CellPattern pattern, std::size_t given) {
    if (given == 0) return;
    if (const auto problem = looking_glass::cellProblem(pattern, given))
        lens.reject("cells", *problem);
}

double slantTangent(DisplayReader& display, TomlReader& lens) {
    if (lens.has("slant_deg"))
        return std::tan(units::radiansFromDeg(display.lensNumber(lens, "slant_deg", {-60, 60})));
    return display.lensNumber(lens, "row_shift_subpixels", {-100, 100}) / 3;
}

/// Eq. 11: X = (m + 1) p_u / (m p_h cos(alpha)).
double opticalPeriod(DisplayReader& display, TomlReader& lens, double tangent) {
    const double pitch = display.lensNumber(lens, "lens_pitch_um", {1, 100'000});
    const double subpixel = display.lensNumber(lens, "subpixel_pitch_um", {1, 10'000});
    const double magnification = display.lensNumber(lens, "magnification", {1, 1e6});
    const double period =
        (magnification + 1) * pitch * std::hypot(1, tangent) / (magnification * subpixel);
    if (!(period >= 1 && period <= 1000))
        lens.reject("lens_pitch_um",
                    "makes a lens of " + plain(period) + " sub-pixels (allowed 1 to 1000)");
    return period;
}

} // namespace

calib::PhaseGrid readPhaseGrid(DisplayReader& display) {
    calib::PhaseGrid grid;
    if (!display.root.has("phase_grid")) return grid;
    auto table = display.root.table("phase_grid");
    grid.columns = table.integer("columns", {1, 256});
    grid.rows = table.integer("rows", {1, 256});
    const double nodes = static_cast<double>(grid.columns) * grid.rows;
    display.noteLensOrigin("cycles");
    grid.cycles = table.numberList("cycles", {nodes, nodes}, {-1, 1});
    return grid;
}

calib::LinearPhase readLinear(DisplayReader& display) {
    auto lens = display.root.table("lens");
    calib::LinearPhase phase;
    phase.perColumn = display.lensNumber(lens, "per_column", kCycles);
    phase.perRow = display.lensNumber(lens, "per_row", kCycles);
    phase.offset = display.lensNumber(lens, "offset", kCycles);
    phase.pattern = readPattern(lens);
    phase.channels.clear();
    if (lens.has("cells")) {
        display.noteLensOrigin("cells");
        for (const auto& row : lens.numberRows("cells", {1, 16}, {3, 3}, kCycles))
            phase.channels.push_back({row[0], row[1], row[2]});
    } else {
        display.noteLensOrigin("channel");
        phase.channels.push_back(lens.numbers<3>("channel", kCycles));
    }
    requireCells(lens, phase.pattern, phase.channels.size());
    if (lens.boolean("bgr", false))
        for (auto& channels : phase.channels)
            std::swap(channels[0], channels[2]);
    phase.grid = readPhaseGrid(display);
    if (lens.boolean("mirror", false)) {
        phase.perColumn = -phase.perColumn;
        phase.perRow = -phase.perRow;
        phase.offset = -phase.offset;
        for (auto& channels : phase.channels)
            for (double& channel : channels)
                channel = -channel;
        for (double& node : phase.grid.cycles)
            node = -node;
    }
    return phase;
}

calib::VanBerkelLens readVanBerkel(DisplayReader& display) {
    auto lens = display.root.table("lens");
    calib::VanBerkelLens sheet;
    const double tangent = slantTangent(display, lens);
    sheet.rowShiftSubpixels = 3 * tangent;
    sheet.subpixelsPerLens = lens.has("lens_pitch_um")
                                 ? opticalPeriod(display, lens, tangent)
                                 : display.lensNumber(lens, "subpixels_per_lens", {1, 1000});
    sheet.offsetSubpixels = display.lensNumber(lens, "offset_subpixels", {-1000, 1000});
    sheet.bgr = lens.boolean("bgr", false);
    sheet.grid = readPhaseGrid(display);
    return sheet;
}

calib::LookingGlassCalibration readLookingGlass(DisplayReader& display) {
    auto lens = display.root.table("lens");
    calib::LookingGlassCalibration unit;
    unit.pitch = display.lensNumber(lens, "pitch", looking_glass::kPitch);
    unit.slope = display.lensNumber(lens, "slope", looking_glass::kSlope);
    if (const auto problem = looking_glass::slopeProblem(unit.slope))
        lens.reject("slope", *problem);
    unit.center = display.lensNumber(lens, "center", looking_glass::kCenter);
    unit.dpi = display.lensNumber(lens, "dpi", looking_glass::kDpi);
    unit.screenWidth = display.profile.width;
    unit.screenHeight = display.profile.height;
    unit.flipImageX = lens.boolean("flip_image_x");
    display.noteLensOrigin("flip_image_x");
    unit.flipImageY = lens.boolean("flip_image_y", false);
    unit.flipSubpixels = lens.boolean("flip_subpixels", false);
    unit.pattern = readPattern(lens);
    if (lens.has("cells")) {
        display.noteLensOrigin("cells");
        for (const auto& row :
             lens.numberRows("cells", looking_glass::kCells, {6, 6}, looking_glass::kCellOffset))
            unit.cells.push_back({{{row[0], row[1]}, {row[2], row[3]}, {row[4], row[5]}}});
    }
    if (unit.cells.empty() && unit.pattern != calib::CellPattern::Single)
        lens.reject("cell_pattern", "needs cells (allowed single without)");
    requireCells(lens, unit.pattern, unit.cells.size());
    display.profile.widthM = units::metresFromInches(unit.screenWidth / unit.dpi);
    display.profile.fringe = lens.integer("fringe", looking_glass::kFringe, 0);
    unit.grid = readPhaseGrid(display);
    return unit;
}

calib::CubeviCalibration readCubevi(DisplayReader& display) {
    auto lens = display.root.table("lens");
    calib::CubeviCalibration unit;
    unit.subpixelsPerLens =
        display.lensNumber(lens, "subpixels_per_lens", cubevi::kSubpixelsPerLens);
    unit.slope = display.lensNumber(lens, "slope", cubevi::kSlope);
    unit.offsetSubpixels = display.lensNumber(lens, "offset_subpixels", cubevi::kOffset);
    unit.grid = readPhaseGrid(display);
    return unit;
}

calib::TrackedLens readTrackedLens(DisplayReader& display) {
    auto lens = display.root.table("lens");
    calib::TrackedLens law;
    law.periodPx = display.lensNumber(lens, "period_px", {0.5, 1000});
    law.rowIncrementPx = display.lensNumber(lens, "row_increment_px", {-100, 100});
    law.initPx = display.lensNumber(lens, "init_px", {-1000, 1000});
    law.fill = display.lensNumber(lens, "fill_px", {0.01, 1000}) / law.periodPx;
    if (law.fill > 0.999) lens.reject("fill_px", "lights the whole period (allowed < period_px)");
    law.eyeGainPx = display.lensNumber(lens, "eye_gain_px", {-1e6, 1e6});
    law.zBiasM = display.lensNumber(lens, "z_bias_m", {-10, 10});
    law.grid = readPhaseGrid(display);
    return law;
}

} // namespace autostereo::config
