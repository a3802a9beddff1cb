#pragma once

#include <glm/vec3.hpp>

namespace autostereo::calib {

/// Both eyes of a viewer in display space: metres, origin at the panel's centre, x right, y up, z
/// to the viewer.
struct EyePair {
    glm::dvec3 left{0};
    glm::dvec3 right{0};

    [[nodiscard]] glm::dvec3 middle() const { return (left + right) * 0.5; }
};

/// Between two pairs: 0 is `a`, 1 is `b`.
[[nodiscard]] inline EyePair mix(const EyePair& a, const EyePair& b, double share) {
    return {a.left + (b.left - a.left) * share, a.right + (b.right - a.right) * share};
}

} // namespace autostereo::calib
