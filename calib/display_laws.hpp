#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <variant>
#include <vector>

// What the glass of each display family is, in the numbers that its maker or its calibration gives.
// Sub-pixel (x, y, c): column and row from the top left, c = 0, 1, 2 for R, G, B. Phases are in
// cycles: lens or slit periods. Plain values, SI units; `config` checks their ranges.

namespace autostereo::calib {

/// Which of several sub-pixel cells a pixel has, by its column x and its row y from the BOTTOM.
/// The first five are the vendor's CellPatternMode 0..4, the last an unconfirmed reading of 2.
enum class CellPattern { Single, Checkerboard, Columns, Staircase, Rows, FourRows };

[[nodiscard]] constexpr int cellCount(CellPattern pattern) {
    if (pattern == CellPattern::Single) return 1;
    return pattern == CellPattern::Staircase || pattern == CellPattern::FourRows ? 4 : 2;
}
[[nodiscard]] constexpr int cellOf(CellPattern pattern, int x, int yUp) {
    switch (pattern) {
    case CellPattern::Single:
        return 0;
    case CellPattern::Checkerboard:
        return (x + yUp) % 2;
    case CellPattern::Columns:
        return x % 2;
    case CellPattern::Staircase:
        return (yUp + 2 * (x % 2)) % 4;
    case CellPattern::Rows:
        return yUp % 2;
    case CellPattern::FourRows:
        return yUp % 4;
    }
    return 0;
}

/// Local correction where the optical sheet is deformed: cycles that a law adds to its phase, at
/// nodes that span the panel's pixels from corner to corner, row by row from the top, bilinear in
/// between. Empty: none.
struct PhaseGrid {
    int columns = 0;
    int rows = 0;
    std::vector<double> cycles;
};

/// phase(x, y, c) = perColumn x + perRow y + channels[cell(x, y)][c] + offset + grid(x, y),
/// wrapping. Vendor's view = floor(views * phase).
struct LinearPhase {
    double perColumn = 0;
    double perRow = 0;
    std::vector<std::array<double, 3>> channels{{0, 0, 0}}; ///< one per cell of the pattern
    double offset = 0;
    CellPattern pattern = CellPattern::Single;
    PhaseGrid grid{};
};

/// A slanted lens or slit over an RGB-stripe panel, in sub-pixels (van Berkel 1999; Eq. 11 of the
/// super-multi-view paper): view(k, l) = floor(N fract((k + offset - rowShift l) / X)), k = 3x + c.
struct VanBerkelLens {
    double subpixelsPerLens = 0;  ///< X
    double rowShiftSubpixels = 0; ///< 3 tan(alpha): the pattern moves right by this much per row
    double offsetSubpixels = 0;
    bool bgr = false;
    PhaseGrid grid{};
};

/// Offsets of R, G, B from the pixel's centre, in pixels; y up.
using SubpixelCell = std::array<std::array<double, 2>, 3>;

/// Numbers of a Looking Glass unit as its calibration file has them.
struct LookingGlassCalibration {
    double pitch = 0;  ///< lenses per inch, perpendicular to the lenses
    double slope = 0;  ///< pixels down per pixel sideways; the sign is the direction of the slant
    double center = 0; ///< phase offset in cycles
    double dpi = 0;
    int screenWidth = 0;
    int screenHeight = 0;
    bool flipImageX = false;         ///< mirrored lens: negates tilt and sub-pixel step
    bool flipImageY = false;         ///< rows counted from the top, picture upside down
    bool flipSubpixels = false;      ///< BGR stripe
    std::vector<SubpixelCell> cells; ///< third generation; empty: RGB stripe
    CellPattern pattern = CellPattern::Single;
    PhaseGrid grid{};
};

/// CubeVi C1: view = floor(N fract((3 (x1 + y1 slope) + c + offset) / X)), x1 and y1 from 1.
struct CubeviCalibration {
    double subpixelsPerLens = 0; ///< vendor's lineNumber
    double slope = 0;            ///< vendor's obliquity
    double offsetSubpixels = 0;  ///< vendor's deviation
    PhaseGrid grid{};
};

/// A small pattern of view numbers that repeats over the panel from the top left: rows of equal
/// length, an entry a sub-pixel (2008 papers' Figure 4; interlaced, checkerboard, anaglyph, flat).
struct ViewTable {
    std::vector<std::vector<int>> rows;
};

/// Every sub-pixel's phase, 2^32 = one cycle, [y][x][c], made beforehand. Shared: up to 1 GiB.
struct ViewLut {
    int width = 0;
    int height = 0;
    std::shared_ptr<const std::vector<std::uint32_t>> phases;
};

/// Brightness of a view over its phase: 0 -> 1 over [riseStart, riseEnd], back over [fallStart,
/// fallEnd], and -negativeLobe elsewhere, which takes away what leaks there (rlk's interleaver).
struct Waveform {
    std::array<std::array<double, 4>, 3> edges{}; ///< per channel: R, G, B
    double negativeLobe = 0;
};

/// Parallax barrier in front of the panel (Kooima 2007, section 2.1): two tracked eyes, or more
/// fixed ones. A sub-pixel is lit for an eye where the fraction of its line screen phase, less
/// half a guard band at either end, is at least `dutyCycle`.
struct LineScreen {
    /// Exact: the point of the screen that the eye sees a sub-pixel through. Paper: the paper's
    /// matrices, which reduce the pitch after rotation and shift.
    enum class Form { Exact, Paper };

    double linesPerM = 0;                     ///< p, perpendicular to the lines
    double dutyCycle = 0;                     ///< c: opaque share of a period
    double thicknessM = 0;                    ///< t, air-equivalent distance from the pixels
    double angleRad = 0;                      ///< a, the paper's Rot(+a)
    double shiftM = 0;                        ///< s, along x
    double guard = 0;                         ///< cycles kept dark on top of the duty cycle
    std::array<double, 3> subpixelOffsetsM{}; ///< of R, G, B from the pixel's centre, along x
    Form form = Form::Exact;
    std::vector<glm::dvec3> eyes;   ///< display space, left to right; where nobody is tracked
    std::vector<Waveform> waveform; ///< none or one
    PhaseGrid grid{};
};

/// Lenses with two tracked eyes, in pixels: for an eye e, phase = (x + c/3 - rowIncrement y -
/// init(e)) / period, lit where fract(phase) < fill; init = initPx + eyeGainPx (e.x + rowIncrement
/// e.y) / (sqrt(1 + rowIncrement^2) (e.z + zBias)).
struct TrackedLens {
    double periodPx = 0;
    double rowIncrementPx = 0;
    double initPx = 0;
    double fill = 0; ///< cycles
    double eyeGainPx = 0;
    double zBiasM = 0;
    PhaseGrid grid{};
};

/// The panel shows whole views side by side: half frames for other displays, quilts for players.
/// Tiles are floor(panel / count) pixels; what is left over stays black.
struct TileFrame {
    int columns = 1;
    int rows = 1;
    bool topFirst = true; ///< false: view 0 bottom left, as quilts have it
    bool swapped = false; ///< views counted from the right
};

/// Philips WOWvx: left half the picture, right half its disparity, a header in the top row's blue.
struct DepthFrame {
    int contentType = 2;
    int factor = 64;
    int offset = 128;
    bool header = true;
    double screenLevel = 127.5; ///< grey in the panel's plane
    double gain = 0;            ///< grey levels per panel width of disparity at |b| = 1
};

using DisplayLaw =
    std::variant<LinearPhase, VanBerkelLens, LookingGlassCalibration, CubeviCalibration, ViewTable,
                 ViewLut, LineScreen, TrackedLens, TileFrame, DepthFrame>;

/// The grid of those laws that have one.
template<class Law> // DisplayLaw or const DisplayLaw
[[nodiscard]] auto* phaseGrid(Law& law) {
    using Grid = std::conditional_t<std::is_const_v<Law>, const PhaseGrid, PhaseGrid>;
    return std::visit(
        [](auto& known) -> Grid* {
            if constexpr (requires { known.grid; }) return &known.grid;
            return nullptr;
        },
        law);
}

/// The glass or the format decides how many views there are; else any number can be spread over
/// its phase.
[[nodiscard]] inline bool hasFixedViews(const DisplayLaw& law) {
    return std::holds_alternative<ViewTable>(law) || std::holds_alternative<LineScreen>(law) ||
           std::holds_alternative<TrackedLens>(law) || std::holds_alternative<TileFrame>(law) ||
           std::holds_alternative<DepthFrame>(law);
}

} // namespace autostereo::calib
