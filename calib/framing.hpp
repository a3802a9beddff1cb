#pragma once

#include "calib/sensor_rig.hpp"

#include <glm/vec2.hpp>

namespace autostereo::calib {

/// What the panel shows of the cyclopean camera (the colour camera, undistorted): a rectangle of
/// its z = 1 plane. u runs left to right and v bottom to top over [0, 1]; this is the one place
/// where image rows (y down) turn into display space (y up).
struct Framing {
    double left = 0;   ///< x/z at u = 0
    double bottom = 0; ///< y/z at v = 0 (y down, so the largest)
    double width = 1;
    double height = 1;

    [[nodiscard]] glm::dvec2 panelFromRay(const glm::dvec2& ray) const {
        return {(ray.x - left) / width, (bottom - ray.y) / height};
    }
    [[nodiscard]] bool operator==(const Framing&) const = default;
    [[nodiscard]] glm::dvec2 rayFromPanel(const glm::dvec2& uv) const {
        return {left + uv.x * width, bottom - uv.y * height};
    }
};

/// The largest rectangle of the panel's shape that both cameras cover from half the focus on,
/// with a margin of `overscan` panel widths at either side (views look past the edges by as much).
[[nodiscard]] Framing framePanel(const SensorRig& rig, double panelAspect, double overscan,
                                 double focusM);

} // namespace autostereo::calib
