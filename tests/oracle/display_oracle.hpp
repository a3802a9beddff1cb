#pragma once

#include "calib/display_profile.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>

// Slow, obvious twin of phase tables, view and band maps: each vendor's formula as it is published,
// in extended precision, from the numbers of the display file.

namespace autostereo::oracle {

using Real = long double;

/// [0, 1). By truncation: the floor of an extended number is a slow instruction.
inline Real fraction(Real cycles) {
    const Real rest = cycles - static_cast<Real>(static_cast<long long>(cycles));
    return rest < 0 ? rest + 1 : rest;
}

/// Eq. 11, with half of the least step added where sub-pixels lie on boundaries (rational lenses).
inline Real vanBerkel(const calib::VanBerkelLens& lens, Real halfStep, int x, int y, int c) {
    const int stripe = lens.bgr ? 2 - c : c;
    const Real k = 3 * x + stripe + static_cast<Real>(lens.offsetSubpixels);
    return (k - static_cast<Real>(lens.rowShiftSubpixels) * y) / lens.subpixelsPerLens + halfStep;
}

/// The vendor's shader formula.
struct LookingGlass {
    explicit LookingGlass(const calib::LookingGlassCalibration& calibration)
        : unit(calibration), w(unit.screenWidth), h(unit.screenHeight),
          pitch(unit.pitch * w / unit.dpi * std::cos(std::atan(1 / Real{unit.slope}))),
          tilt(h / (w * unit.slope) * (unit.flipImageX ? -1 : 1)),
          subpixel(1 / (3 * w) * (unit.flipImageX ? -1 : 1)) {}

    [[nodiscard]] Real operator()(int x, int y, int c) const {
        const int channel = unit.flipSubpixels ? 2 - c : c;
        const int yUp = unit.screenHeight - 1 - y;
        Real u = (x + Real{0.5}) / w, v = ((unit.flipImageY ? y : yUp) + Real{0.5}) / h;
        if (unit.cells.empty()) {
            u += channel * subpixel;
        } else {
            const auto& offsets = unit.cells.at(static_cast<std::size_t>(cell(x, yUp)))
                                      .at(static_cast<std::size_t>(channel));
            u += offsets[0] / w;
            v += offsets[1] / h;
        }
        return 1 - fraction((u + v * tilt) * pitch - unit.center);
    }
    /// The vendor's five modes, written out: 0, checkerboard, columns, staircase, rows.
    [[nodiscard]] int cell(int x, int yUp) const {
        switch (unit.pattern) {
        case calib::CellPattern::Single:
            return 0;
        case calib::CellPattern::Checkerboard:
            return x % 2 == yUp % 2 ? 0 : 1;
        case calib::CellPattern::Columns:
            return x % 2;
        case calib::CellPattern::Staircase:
            return (yUp + 2 * (x % 2)) % 4;
        case calib::CellPattern::Rows:
            return yUp % 2;
        case calib::CellPattern::FourRows:
            return yUp % 4;
        }
        return 0;
    }

    calib::LookingGlassCalibration unit;
    Real w, h, pitch, tilt, subpixel;
};

inline Real cubevi(const calib::CubeviCalibration& unit, int x, int y, int c) {
    const Real x1 = ((x + 1) + (y + 1) * static_cast<Real>(unit.slope)) * 3 + c;
    return (x1 + unit.offsetSubpixels) / unit.subpixelsPerLens;
}

/// The paper's section 3.2 for an eye, as matrices; exact: the point of the screen that the ray
/// from the sub-pixel to the eye goes through.
inline Real lineScreen(const calib::LineScreen& screen, const calib::DisplayProfile& display,
                       const glm::dvec3& eye, int x, int y, int c) {
    const Real pixel = static_cast<Real>(display.widthM) / display.width;
    const Real px = (x + Real{0.5} - static_cast<Real>(display.width) / 2) * pixel +
                    screen.subpixelOffsetsM.at(static_cast<std::size_t>(c));
    const Real py = (static_cast<Real>(display.height) / 2 - y - Real{0.5}) * pixel;
    const Real t = screen.thicknessM, cosine = std::cos(Real{screen.angleRad}),
               sine = std::sin(Real{screen.angleRad});
    if (screen.form == calib::LineScreen::Form::Paper) {
        const Real p = screen.linesPerM * (eye.z - t) / eye.z;
        const Real s = screen.shiftM * (eye.z - t) / eye.z;
        const Real tx = px + t * eye.x / eye.z - s, ty = py + t * eye.y / eye.z;
        return p * (cosine * tx - sine * ty);
    }
    const Real along = t / eye.z; // of the way from the sub-pixel to the eye
    const Real qx = px + (eye.x - px) * along, qy = py + (eye.y - py) * along;
    return screen.linesPerM * (cosine * (qx - screen.shiftM) - sine * qy);
}

inline Real trackedLens(const calib::TrackedLens& lens, const glm::dvec3& eye, int x, int y,
                        int c) {
    const Real slant = lens.rowIncrementPx;
    const Real init = lens.initPx + lens.eyeGainPx * (eye.x + slant * eye.y) /
                                        std::sqrt(1 + slant * slant) / (eye.z + lens.zBiasM);
    return (x + c / Real{3} - (y * slant + init)) / lens.periodPx;
}

/// Half of the least distance between two sub-pixels' places among the views of a lens whose
/// numbers are fractions with a denominator up to 64; 0 for others.
inline Real halfStep(const calib::VanBerkelLens& lens, int views) {
    for (int q = 1; q <= 64; ++q) {
        const auto whole = [&](double number) {
            return std::abs(q * number - std::round(q * number)) < 1e-9;
        };
        if (!whole(lens.subpixelsPerLens) || !whole(lens.rowShiftSubpixels) ||
            !whole(lens.offsetSubpixels))
            continue;
        const auto steps = std::lround(q * lens.subpixelsPerLens);
        long common = steps;
        while (common % views != 0)
            common += steps;
        return Real{1} / static_cast<Real>(2 * common);
    }
    return 0;
}

inline int vendorViews(const calib::DisplayProfile& display) {
    return display.remap.empty() ? display.views : static_cast<int>(display.remap.size());
}

using PhaseFunction = std::function<Real(int x, int y, int c)>;

/// Vendor's phase, [0, 1), of displays that have one for all eyes; empty for others.
inline PhaseFunction phaseFunction(const calib::DisplayProfile& display) {
    const int views = vendorViews(display);
    if (const auto* law = std::get_if<calib::LinearPhase>(&display.law))
        return [l = *law](int x, int y, int c) {
            return fraction(static_cast<Real>(l.perColumn) * x + static_cast<Real>(l.perRow) * y +
                            l.channels.front().at(static_cast<std::size_t>(c)) + l.offset);
        };
    if (const auto* lens = std::get_if<calib::VanBerkelLens>(&display.law))
        return [l = *lens, half = halfStep(*lens, views)](int x, int y, int c) {
            return fraction(vanBerkel(l, half, x, y, c));
        };
    if (const auto* unit = std::get_if<calib::LookingGlassCalibration>(&display.law))
        return LookingGlass(*unit);
    if (const auto* unit = std::get_if<calib::CubeviCalibration>(&display.law))
        return [u = *unit](int x, int y, int c) { return fraction(cubevi(u, x, y, c)); };
    if (const auto* table = std::get_if<calib::ViewTable>(&display.law))
        return [rows = table->rows, views](int x, int y, int c) {
            const auto& row = rows.at(static_cast<std::size_t>(y) % rows.size());
            const auto k = 3 * static_cast<std::size_t>(x) + static_cast<std::size_t>(c);
            return (row.at(k % row.size()) + Real{0.5}) / views;
        };
    return {};
}

/// Distance of a phase to the nearest boundary between two of N views, cycles.
inline Real toBoundary(Real phase, int views) {
    const Real within = fraction(phase * views);
    return std::min(within, 1 - within) / views;
}

/// View of a phase, counted from the left; -1: black.
inline int viewOf(const calib::DisplayProfile& display, Real phase) {
    const int views = vendorViews(display);
    const int vendor = std::min(static_cast<int>(phase * views), views - 1);
    if (!display.remap.empty()) return display.remap.at(static_cast<std::size_t>(vendor));
    return display.order == calib::ViewOrder::RightToLeft ? views - 1 - vendor : vendor;
}

} // namespace autostereo::oracle
