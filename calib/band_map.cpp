#include "calib/band_map.hpp"

#include "calib/view_map.hpp"

#include <glm/vec2.hpp>

#include <cmath>

namespace autostereo::calib {

LinearPhase lineScreenPhase(const LineScreen& screen, const DisplayProfile& display, int width,
                            int height, const glm::dvec3& eye) {
    // Section 3.2: parallax t v / v_z, apparent scale k = (v_z - t) / v_z. A point X of the panel
    // is seen through k X + t v / v_z of the screen; the paper writes k (X - s) + k t v / v_z.
    const double scale = (eye.z - screen.thicknessM) / eye.z;
    const bool paper = screen.form == LineScreen::Form::Paper;
    const double outer = screen.linesPerM * (paper ? scale : 1);
    const double inner = paper ? 1 : scale;
    const double shift = screen.shiftM * (paper ? scale : 1);
    const glm::dvec2 parallax = glm::dvec2(eye) * (screen.thicknessM / eye.z);
    const double across = outer * std::cos(screen.angleRad);
    const double up = -outer * std::sin(screen.angleRad);

    const double pixelX = display.widthM / width, pixelY = display.heightM() / height;
    const double firstX = (0.5 - width / 2.0) * pixelX, firstY = (height / 2.0 - 0.5) * pixelY;
    LinearPhase phase;
    phase.perColumn = across * inner * pixelX;
    phase.perRow = -up * inner * pixelY;
    phase.offset =
        across * (inner * firstX + parallax.x - shift) + up * (inner * firstY + parallax.y);
    for (std::size_t c = 0; c < 3; ++c)
        phase.channels[0][c] = across * inner * screen.subpixelOffsetsM[c];
    phase.grid = screen.grid;
    return phase;
}

LinearPhase trackedLensPhase(const TrackedLens& lens, const glm::dvec3& eye) {
    const double slant = lens.rowIncrementPx;
    const double sideways = (eye.x + slant * eye.y) / std::hypot(1, slant);
    const double init = lens.initPx + lens.eyeGainPx * sideways / (eye.z + lens.zBiasM);
    LinearPhase phase;
    phase.perColumn = 1 / lens.periodPx;
    phase.perRow = -slant / lens.periodPx;
    phase.channels = {{0, 1 / (3 * lens.periodPx), 2 / (3 * lens.periodPx)}};
    phase.offset = -init / lens.periodPx;
    phase.grid = lens.grid;
    return phase;
}

std::vector<glm::dvec3> nominalEyes(const DisplayProfile& display) {
    const double reach = display.viewingDistanceM * std::tan(display.coneRad / 2);
    std::vector<glm::dvec3> eyes;
    eyes.reserve(static_cast<std::size_t>(display.views));
    for (int view = 0; view < display.views; ++view)
        eyes.emplace_back(viewPosition(display, view) * reach, 0, display.viewingDistanceM);
    return eyes;
}

namespace {

/// Cycles -> units, up to a whole cycle, which wrapping cannot hold.
std::uint32_t bandWidth(double cycles) {
    return static_cast<std::uint32_t>(std::llround(std::ldexp(cycles, 32)));
}

template<class LawOfEye>
BandMap bandsOf(const std::vector<glm::dvec3>& eyes, int width, int height, LawOfEye lawOf) {
    BandMap map;
    map.eyes.reserve(eyes.size());
    for (const glm::dvec3& eye : eyes)
        map.eyes.push_back(phaseTables(lawOf(eye), width, height));
    return map;
}

} // namespace

BandMap bandMap(const DisplayProfile& display, int width, int height,
                const std::vector<glm::dvec3>& eyes) {
    const auto orElse = [&](const std::vector<glm::dvec3>& own) {
        if (!eyes.empty()) return eyes;
        return own.empty() ? nominalEyes(display) : own;
    };
    if (const auto* lens = std::get_if<TrackedLens>(&display.law)) {
        BandMap map = bandsOf(orElse({}), width, height,
                              [&](const glm::dvec3& eye) { return trackedLensPhase(*lens, eye); });
        map.width = bandWidth(lens->fill);
        return map;
    }
    const auto& screen = std::get<LineScreen>(display.law);
    BandMap map = bandsOf(orElse(screen.eyes), width, height, [&](const glm::dvec3& eye) {
        return lineScreenPhase(screen, display, width, height, eye);
    });
    map.start = turns(screen.dutyCycle + screen.guard / 2);
    map.width = bandWidth(1 - screen.dutyCycle - screen.guard);
    if (!screen.waveform.empty()) map.waveform = screen.waveform.front();
    return map;
}

} // namespace autostereo::calib
