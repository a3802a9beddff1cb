#pragma once

#include "calib/display_profile.hpp"
#include "calib/eye_pair.hpp"
#include "tests/oracle/view_oracle.hpp"

#include <cmath>

// Slow, obvious, double-precision twin of what an eye anywhere in front of the panel sees: each
// node as a point in display space, and where the ray from the eye through it meets the panel.

namespace autostereo::oracle {

/// The layer's nodes moved to their places on the panel as the eye sees them; disparity is used up.
inline Layer seenFrom(Layer layer, const calib::DisplayProfile& display, const glm::dvec3& eye) {
    const double distance = display.viewingDistanceM;
    const double reach = distance * std::tan(display.coneRad / 2); // of |b| = 1, metres
    for (auto& node : layer.nodes) {
        if (!node) continue;
        const double d = node->d * display.widthM;
        const double height = d * distance / (reach + d); // from d = reach Z / (D - Z)
        const glm::dvec3 nominal{0, 0, distance};
        const glm::dvec3 shown{(node->u - 0.5) * display.widthM,
                               (node->v - 0.5) * display.heightM(), 0};
        // On the ray from the nominal eye to where the cyclopean picture shows it.
        const glm::dvec3 point = nominal + (shown - nominal) * ((distance - height) / distance);
        const glm::dvec3 seen = eye + (point - eye) * (eye.z / (eye.z - point.z));
        node->u = seen.x / display.widthM + 0.5;
        node->v = seen.y / display.heightM() + 0.5;
        node->d = 0;
    }
    return layer;
}

/// Scene and background as the eye sees them, at width x height pixels.
inline Picture eyePicture(const Layer& scene, const Layer& background, const Picture& color,
                          const Picture& backgroundColor, const calib::DisplayProfile& display,
                          const glm::dvec3& eye, int width, int height) {
    ViewDrawing drawing(width, height, {});
    drawing.draw(seenFrom(scene, display, eye), 0, color);
    drawing.draw(seenFrom(background, display, eye), 0, backgroundColor);
    return drawing.picture();
}

} // namespace autostereo::oracle
