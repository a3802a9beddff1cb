#include "calib/optics.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace autostereo::calib {

namespace {

/// Axes as seen on the panel from (0, 0, D).
struct PanelLines {
    double periodM;
    double slant;
    double axisM;
};

/// What a law says, as far as this file needs it.
struct Sheet {
    PanelLines lines;
    std::optional<double> gapM; ///< that the law itself gives
};

SubpixelLayout stripes(const DisplayProfile& display, bool bgr = false) {
    SubpixelLayout layout;
    layout.width = display.width;
    layout.height = display.height;
    layout.pixelM = display.widthM / display.width;
    const double third = layout.pixelM / 3;
    layout.offsetsM = {{{{-third, 0}, {0, 0}, {third, 0}}}};
    if (bgr) std::swap(layout.offsetsM[0][0], layout.offsetsM[0][2]);
    return layout;
}

/// Sub-pixel column k (3x + place in the stripe) and row y have
/// phase = perColumn k + perRow y + offset; lines where it is 1/2.
PanelLines stripeLines(const DisplayProfile& display, double perColumn, double perRow,
                       double offset) {
    const double subpixel = display.widthM / (3 * display.width);
    const double middleRow = display.height / 2.0 - 0.5;
    const double k = (0.5 - offset - perRow * middleRow) / perColumn;
    return {subpixel / std::abs(perColumn), perRow / (3 * perColumn),
            (k + 0.5) * subpixel - display.widthM / 2};
}

bool whole(double number) { return std::abs(number - std::round(number)) < 1e-9; }

/// A rational sheet lies so that no sub-pixel is on a boundary between two of N views: half of the
/// finest step that both are multiples of. Cycles; 0 for other sheets.
double halfStep(const VanBerkelLens& lens, int views) {
    const double period = lens.subpixelsPerLens;
    for (int q = 1; q <= 64; ++q) {
        if (!whole(q * period) || !whole(q * lens.rowShiftSubpixels) ||
            !whole(q * lens.offsetSubpixels))
            continue;
        long steps = std::lround(q * period);
        const long least = steps;
        while (steps % views != 0)
            steps += least;
        return 0.5 / static_cast<double>(steps);
    }
    return 0;
}

int vendorViews(const DisplayProfile& display) {
    return display.remap.empty() ? display.views : static_cast<int>(display.remap.size());
}

Sheet sheetOf(const DisplayProfile& display, const VanBerkelLens& lens) {
    const double period = lens.subpixelsPerLens;
    const double offset = lens.offsetSubpixels / period + halfStep(lens, vendorViews(display));
    return {stripeLines(display, 1 / period, -lens.rowShiftSubpixels / period, offset), {}};
}

Sheet sheetOf(const DisplayProfile& display, const CubeviCalibration& unit) {
    // The vendor counts columns and rows from 1.
    const double period = unit.subpixelsPerLens;
    const double offset = (3 + 3 * unit.slope + unit.offsetSubpixels) / period;
    return {stripeLines(display, 1 / period, 3 * unit.slope / period, offset), {}};
}

Sheet sheetOf(const DisplayProfile& display, const LinearPhase& law) {
    // Its x is the pixel's centre, which is k = 3x + 1.
    return {stripeLines(display, law.perColumn / 3, law.perRow, law.offset - law.perColumn / 3),
            {}};
}

/// a = (u + v tilt) pitch' - center is 1/2 on the axes; u and v go from the lower left corner.
Sheet sheetOf(const DisplayProfile& display, const LookingGlassCalibration& unit) {
    constexpr double kInch = 0.0254;
    const double period = kInch / (unit.pitch * std::cos(std::atan(1 / unit.slope)));
    const double slant = (unit.flipImageX ? 1 : -1) / unit.slope;
    const double cornerX = -display.widthM / 2, cornerY = -display.heightM() / 2;
    return {{period, slant, cornerX - slant * cornerY + (unit.center + 0.5) * period}, {}};
}

Sheet sheetOf(const DisplayProfile& display, const TrackedLens& lens) {
    const double pixel = display.widthM / display.width;
    const double middle = 0.5 - lens.fill / 2 - lens.initPx / lens.periodPx;
    // An eye that moves by 1 moves the point seen through a given lens by -gap / (D - gap), which
    // the law calls gain / (sqrt(1 + s^2) (D + bias)).
    const double nominal = display.viewingDistanceM;
    const double moves =
        -lens.eyeGainPx * pixel / std::hypot(1, lens.rowIncrementPx) / (nominal + lens.zBiasM);
    return {
        stripeLines(display, 1 / (3 * lens.periodPx), -lens.rowIncrementPx / lens.periodPx, middle),
        nominal * moves / (1 + moves)};
}

/// v = (across k + down y + first) mod N everywhere in the table, or nothing. Of the steps that are
/// the same modulo N the smallest is meant: the others make lenses that no eye resolves.
std::optional<std::array<int, 3>> regularSteps(const ViewTable& table, int views) {
    const auto smallest = [views](int step) {
        step = (step % views + views) % views;
        return 2 * step > views ? step - views : step;
    };
    const int columns = static_cast<int>(table.rows.front().size());
    const int rows = static_cast<int>(table.rows.size());
    const int first = table.rows[0][0];
    const int across = smallest(table.rows[0][columns > 1 ? 1 : 0] - first);
    const int down = smallest(table.rows[rows > 1 ? 1 : 0][0] - first);
    if (across == 0 || smallest(across * columns) != 0 || smallest(down * rows) != 0)
        return std::nullopt;
    for (int y = 0; y < rows; ++y)
        for (int k = 0; k < columns; ++k)
            if (smallest(table.rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(k)] -
                         across * k - down * y - first) != 0)
                return std::nullopt;
    return std::array{across, down, first};
}

std::optional<Sheet> sheetOf(const DisplayProfile& display, const ViewTable& table) {
    const int views = vendorViews(display);
    const auto steps = regularSteps(table, views);
    if (!steps || display.optics.gapM == 0) return std::nullopt;
    const auto [across, down, first] = *steps; // a view is seen in the middle of its share
    return Sheet{stripeLines(display, static_cast<double>(across) / views,
                             static_cast<double>(down) / views, (first + 0.5) / views),
                 {}};
}

std::optional<Sheet> sheet(const DisplayProfile& display) {
    if (const auto* law = std::get_if<LinearPhase>(&display.law))
        return law->perColumn == 0 ? std::nullopt : std::optional(sheetOf(display, *law));
    if (const auto* lens = std::get_if<VanBerkelLens>(&display.law)) return sheetOf(display, *lens);
    if (const auto* unit = std::get_if<LookingGlassCalibration>(&display.law))
        return sheetOf(display, *unit);
    if (const auto* unit = std::get_if<CubeviCalibration>(&display.law))
        return sheetOf(display, *unit);
    if (const auto* lens = std::get_if<TrackedLens>(&display.law)) return sheetOf(display, *lens);
    if (const auto* table = std::get_if<ViewTable>(&display.law)) return sheetOf(display, *table);
    return std::nullopt;
}

/// A law corrects at the sub-pixel, which an eye in the nominal place sees through the lens there.
void correct(LensArray& lenses, const DisplayProfile& display) {
    const PhaseGrid* grid = phaseGrid(display.law);
    if (grid == nullptr) return;
    lenses.correction = turnedGrid(display, *grid);
    const double pixel =
        (1 - lenses.gapM / display.viewingDistanceM) * display.widthM / display.width;
    lenses.correctedM = {pixel * (display.width - 1), pixel * (display.height - 1)};
}

LensArray lensesOf(const Sheet& sheet, const DisplayProfile& display) {
    const double distance = display.viewingDistanceM, period = sheet.lines.periodM;
    const Optics& optics = display.optics;
    // gap = pitch / (2 tan(cone/2)) with pitch = period (1 - gap/D), solved for the gap.
    const double fanned = period / (2 * std::tan(display.coneRad / 2) + period / distance);
    LensArray lenses;
    lenses.kind = optics.kind;
    lenses.gapM = optics.gapM > 0 ? optics.gapM : sheet.gapM.value_or(fanned);
    const double scale = 1 - lenses.gapM / distance;
    lenses.pitchM = period * scale;
    lenses.slant = sheet.lines.slant;
    lenses.axisM = sheet.lines.axisM * scale;
    lenses.aperture = optics.aperture;

    correct(lenses, display);
    return lenses;
}

SubpixelLayout subpixelsOf(const DisplayProfile& display) {
    if (const auto* screen = std::get_if<LineScreen>(&display.law)) {
        SubpixelLayout layout = stripes(display);
        for (std::size_t c = 0; c < 3; ++c)
            layout.offsetsM[0][c] = {screen->subpixelOffsetsM[c], 0};
        return layout;
    }
    if (const auto* lens = std::get_if<VanBerkelLens>(&display.law))
        return stripes(display, lens->bgr);
    SubpixelLayout layout = stripes(display);
    const double pixel = layout.pixelM;
    if (const auto* law = std::get_if<LinearPhase>(&display.law)) {
        layout.pattern = law->pattern;
        layout.offsetsM.clear();
        const double perCycle = pixel / law->perColumn;
        for (const auto& cell : law->channels)
            layout.offsetsM.push_back(
                {{{cell[0] * perCycle, 0}, {cell[1] * perCycle, 0}, {cell[2] * perCycle, 0}}});
    } else if (const auto* unit = std::get_if<LookingGlassCalibration>(&display.law)) {
        layout.pattern = unit->pattern;
        layout.upsideDown = unit->flipImageY;
        layout.offsetsM.clear();
        const double step = (unit->flipImageX ? -1 : 1) * pixel / 3;
        if (unit->cells.empty()) layout.offsetsM.push_back({{{0, 0}, {step, 0}, {2 * step, 0}}});
        for (const SubpixelCell& cell : unit->cells) {
            auto& offsets = layout.offsetsM.emplace_back();
            for (std::size_t c = 0; c < 3; ++c)
                offsets[c] = glm::dvec2{cell[c][0], cell[c][1]} * pixel;
        }
        if (unit->flipSubpixels)
            for (auto& offsets : layout.offsetsM)
                std::swap(offsets[0], offsets[2]);
    }
    return layout;
}

DisplayOptics lineScreen(const DisplayProfile& display, const LineScreen& screen) {
    const double pitch = 1 / (screen.linesPerM * std::cos(screen.angleRad));
    LensArray slits;
    slits.kind = display.optics.kind;
    slits.pitchM = pitch;
    slits.slant = std::tan(screen.angleRad);
    slits.axisM = screen.shiftM + pitch * (1 + screen.dutyCycle) / 2;
    slits.gapM = screen.thicknessM;
    slits.aperture = display.optics.aperture > 0 ? display.optics.aperture : 1 - screen.dutyCycle;
    correct(slits, display);
    return {std::move(slits), subpixelsOf(display)};
}

/// Nodes a and b, the shorter way round.
double mix(double a, double b, double weight) {
    const double step = b - a;
    return a + (step - std::round(step)) * weight;
}

/// `across` and `down`: share of the way from the first node to the last.
double correctionAt(const PhaseGrid& grid, double across, double down) {
    const double x = std::clamp(across, 0.0, 1.0) * (grid.columns - 1);
    const double y = std::clamp(down, 0.0, 1.0) * (grid.rows - 1);
    const int left = std::clamp(static_cast<int>(x), 0, std::max(0, grid.columns - 2));
    const int upper = std::clamp(static_cast<int>(y), 0, std::max(0, grid.rows - 2));
    const auto node = [&](int column, int row) {
        column = std::min(column, grid.columns - 1);
        row = std::min(row, grid.rows - 1);
        return grid.cycles[static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.columns) +
                           static_cast<std::size_t>(column)];
    };
    return mix(mix(node(left, upper), node(left + 1, upper), x - left),
               mix(node(left, upper + 1), node(left + 1, upper + 1), x - left), y - upper);
}

} // namespace

PhaseGrid turnedGrid(const DisplayProfile& display, PhaseGrid grid) {
    const auto* linear = std::get_if<LinearPhase>(&display.law);
    const auto* glass = std::get_if<LookingGlassCalibration>(&display.law);
    if (glass != nullptr || (linear != nullptr && linear->perColumn < 0))
        for (double& node : grid.cycles)
            node = -node;
    if (glass != nullptr && glass->flipImageY)
        for (int upper = 0, lower = grid.rows - 1; upper < lower; ++upper, --lower)
            std::swap_ranges(grid.cycles.begin() + upper * grid.columns,
                             grid.cycles.begin() + (upper + 1) * grid.columns,
                             grid.cycles.begin() + lower * grid.columns);
    return grid;
}

double LensArray::coordinate(const glm::dvec3& eye, const glm::dvec2& panelPoint) const {
    const glm::dvec2 crossing = panelPoint + (glm::dvec2(eye) - panelPoint) * (gapM / eye.z);
    const double cycles = (crossing.x - slant * crossing.y - axisM) / pitchM;
    if (correction.cycles.empty()) return cycles;
    return cycles + correctionAt(correction, 0.5 + crossing.x / correctedM.x,
                                 0.5 - crossing.y / correctedM.y);
}

std::optional<SubpixelLayout> subpixelLayout(const DisplayProfile& display) {
    if (display.optics.kind == Optics::Kind::None) return std::nullopt;
    return subpixelsOf(display);
}

std::optional<DisplayOptics> displayOptics(const DisplayProfile& display) {
    if (display.optics.kind == Optics::Kind::None) return std::nullopt;
    if (const auto* screen = std::get_if<LineScreen>(&display.law))
        return lineScreen(display, *screen);
    const auto found = sheet(display);
    if (!found) return std::nullopt;
    return DisplayOptics{lensesOf(*found, display), subpixelsOf(display)};
}

} // namespace autostereo::calib
