#pragma once

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

namespace autostereo::calib {

/// Rotation, then translation (metres). Name variables `targetFromSource`, so that neighbours
/// cancel when chained: p_color = colorFromDepth * p_depth.
struct RigidTransform {
    glm::dmat3 rotation{1.0};
    glm::dvec3 translation{0.0};

    [[nodiscard]] glm::dvec3 operator*(const glm::dvec3& p) const {
        return rotation * p + translation;
    }
    [[nodiscard]] RigidTransform operator*(const RigidTransform& inner) const {
        return {rotation * inner.rotation, rotation * inner.translation + translation};
    }
    [[nodiscard]] RigidTransform inverse() const {
        const glm::dmat3 back = glm::transpose(rotation);
        return {back, -(back * translation)};
    }
};

} // namespace autostereo::calib
