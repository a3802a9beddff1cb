#pragma once

#include "calib/display_profile.hpp"

#include <cmath>
#include <cstddef>
#include <stdexcept>

// Slow, obvious twin of phase tables, view and band maps: each vendor's formula as it is published,
// in extended precision, from the numbers of the display file.

namespace autostereo::oracle {

using Real = long double;

inline Real fraction(Real cycles) { return cycles - std::floor(cycles); }

/// Eq. 11, with half of the least step added where sub-pixels lie on boundaries (rational lenses).
inline Real vanBerkel(const calib::VanBerkelLens& lens, Real halfStep, int x, int y, int c) {
    const int stripe = lens.bgr ? 2 - c : c;
    const Real k = 3 * x + stripe + static_cast<Real>(lens.offsetSubpixels);
    return (k - static_cast<Real>(lens.rowShiftSubpixels) * y) / lens.subpixelsPerLens + halfStep;
}

inline Real lookingGlass(const calib::LookingGlassCalibration& unit, int x, int y, int c) {
    const Real w = unit.screenWidth, h = unit.screenHeight;
    const Real mirror = unit.flipImageX ? -1 : 1;
    const Real pitch = unit.pitch * w / unit.dpi * std::cos(std::atan(1 / Real{unit.slope}));
    const Real tilt = h / (w * unit.slope) * mirror;
    const Real subpixel = 1 / (3 * w) * mirror;
    const int channel = unit.flipSubpixels ? 2 - c : c;
    const int yUp = static_cast<int>(h) - 1 - y;
    Real u = (x + Real{0.5}) / w, v = ((unit.flipImageY ? y : yUp) + Real{0.5}) / h;
    if (unit.cells.empty()) {
        u += channel * subpixel;
    } else {
        // The vendor's five modes, written out: 0, checkerboard, columns, staircase, rows.
        int cell = 0;
        switch (unit.pattern) {
        case calib::CellPattern::Single:
            break;
        case calib::CellPattern::Checkerboard:
            cell = x % 2 == yUp % 2 ? 0 : 1;
            break;
        case calib::CellPattern::Columns:
            cell = x % 2;
            break;
        case calib::CellPattern::Staircase:
            cell = (yUp + 2 * (x % 2)) % 4;
            break;
        case calib::CellPattern::Rows:
            cell = yUp % 2;
            break;
        case calib::CellPattern::FourRows:
            cell = yUp % 4;
            break;
        }
        const auto& offsets =
            unit.cells.at(static_cast<std::size_t>(cell)).at(static_cast<std::size_t>(channel));
        u += offsets[0] / w;
        v += offsets[1] / h;
    }
    return 1 - fraction((u + v * tilt) * pitch - unit.center);
}

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
    const Real init = lens.initPx + lens.eyeGainPx * (eye.x - slant * eye.y) /
                                        std::sqrt(1 + slant * slant) / (eye.z + lens.zBiasM);
    return (x + c / Real{3} - (y * slant + init)) / lens.periodPx;
}

/// Vendor's phase of displays that have one for all eyes; [0, 1).
inline Real phaseOf(const calib::DisplayProfile& display, int x, int y, int c) {
    const int views =
        display.remap.empty() ? display.views : static_cast<int>(display.remap.size());
    if (const auto* law = std::get_if<calib::LinearPhase>(&display.law))
        return fraction(static_cast<Real>(law->perColumn) * x + static_cast<Real>(law->perRow) * y +
                        law->channels.front().at(static_cast<std::size_t>(c)) + law->offset);
    if (const auto* lens = std::get_if<calib::VanBerkelLens>(&display.law)) {
        // Half of the least distance between two sub-pixels' positions among the views.
        Real step = 0;
        for (int q = 1; q <= 64 && step == 0; ++q) {
            const auto whole = [&](double number) {
                return std::abs(q * number - std::round(q * number)) < 1e-9;
            };
            if (whole(lens->subpixelsPerLens) && whole(lens->rowShiftSubpixels) &&
                whole(lens->offsetSubpixels)) {
                const auto steps = std::lround(q * lens->subpixelsPerLens);
                long common = steps;
                while (common % views != 0)
                    common += steps;
                step = Real{1} / common;
            }
        }
        return fraction(vanBerkel(*lens, step / 2, x, y, c));
    }
    if (const auto* unit = std::get_if<calib::LookingGlassCalibration>(&display.law))
        return lookingGlass(*unit, x, y, c);
    if (const auto* unit = std::get_if<calib::CubeviCalibration>(&display.law))
        return fraction(cubevi(*unit, x, y, c));
    if (const auto* table = std::get_if<calib::ViewTable>(&display.law)) {
        const auto& row = table->rows.at(static_cast<std::size_t>(y) % table->rows.size());
        const auto k = static_cast<std::size_t>(3 * x + c);
        return (row.at(k % row.size()) + Real{0.5}) / views;
    }
    throw std::invalid_argument("oracle: " + display.type + " has no phase for all eyes");
}

/// Distance of a phase to the nearest boundary between two of N views, cycles.
inline Real toBoundary(Real phase, int views) {
    const Real scaled = phase * views;
    return std::abs(scaled - std::round(scaled)) / views;
}

/// View of a phase, counted from the left; -1: black.
inline int viewOf(const calib::DisplayProfile& display, Real phase) {
    const int views =
        display.remap.empty() ? display.views : static_cast<int>(display.remap.size());
    const int vendor = std::min(static_cast<int>(phase * views), views - 1);
    if (!display.remap.empty()) return display.remap.at(static_cast<std::size_t>(vendor));
    return display.order == calib::ViewOrder::RightToLeft ? views - 1 - vendor : vendor;
}

} // namespace autostereo::oracle
