#pragma once

#include "calib/rigid_transform.hpp"

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include <cmath>

namespace autostereo::devices::sim {

/// Where bodies stand, in the scene's frame (y down).

[[nodiscard]] inline glm::dmat3 turn(double radians, const glm::dvec3& axis) {
    return glm::dmat3(glm::rotate(glm::dmat4(1.0), radians, axis));
}

[[nodiscard]] inline calib::RigidTransform standing(const glm::dvec3& centre, double yaw = 0) {
    return {turn(yaw, {0, 1, 0}), centre};
}

/// The body's y axis runs from a to b, its centre lies half way.
[[nodiscard]] inline calib::RigidTransform between(const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 y = glm::normalize(b - a);
    const glm::dvec3 aside = std::abs(y.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
    const glm::dvec3 x = glm::normalize(glm::cross(y, aside));
    return {glm::dmat3(x, y, glm::cross(x, y)), 0.5 * (a + b)};
}

} // namespace autostereo::devices::sim
