#pragma once

#include "calib/sensor_rig.hpp"

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>

namespace autostereo::calib {

/// What the panel shows of the cyclopean camera (the colour camera, undistorted): a rectangle of
/// its z = 1 plane, turned upright. u runs left to right and v bottom to top over [0, 1]; this is
/// the one place where image rows (y down) turn into display space (y up).
struct Framing {
    double left = 0;   ///< upright x/z at u = 0
    double bottom = 0; ///< upright y/z at v = 0 (y down, so the largest)
    double width = 1;
    double height = 1;
    /// From the camera's (x/z, y/z) to upright ones: quarter turns, and x negated for a mirror.
    glm::dmat2 uprightFromCamera{1.0};

    [[nodiscard]] glm::dvec2 panelFromRay(const glm::dvec2& ray) const {
        const glm::dvec2 upright = uprightFromCamera * ray;
        return {(upright.x - left) / width, (bottom - upright.y) / height};
    }
    [[nodiscard]] bool operator==(const Framing&) const = default;
    [[nodiscard]] glm::dvec2 rayFromPanel(const glm::dvec2& uv) const {
        return glm::dvec2{left + uv.x * width, bottom - uv.y * height} * uprightFromCamera;
    }
    /// Whether the panel's width lies along the camera's columns.
    [[nodiscard]] bool isSideways() const { return uprightFromCamera[0][0] == 0; }
};

/// How the cameras are mounted, and which part of what they see the panel shows.
struct FramingChoice {
    /// Both cameras turned clockwise as seen from behind them: 0 to 3 quarters of a turn.
    int quarterTurns = 0;
    bool mirror = false; ///< the panel as a mirror: left and right are exchanged, depth is not
    double zoom = 1;     ///< >= 1; 1: as much as the cameras cover
    /// Where in what they cover: -1 (left, bottom) to 1 (right, top), as shown.
    glm::dvec2 pan{0, 0};
};

/// The largest rectangle of the panel's shape that both cameras cover from half the focus on,
/// with a margin of `overscan` panel widths at either side (views look past the edges by as much);
/// with a zoom the part of it that was chosen.
[[nodiscard]] Framing framePanel(const SensorRig& rig, double panelAspect, double overscan,
                                 double focusM, const FramingChoice& choice = {});

} // namespace autostereo::calib
