#pragma once

#include "calib/rigid_transform.hpp"
#include "devices/sim/texture.hpp"

#include <glm/vec3.hpp>

#include <limits>

namespace autostereo::devices::sim {

/// `direction` of any length; distances along a ray count in lengths of it.
struct Ray {
    glm::dvec3 origin;
    glm::dvec3 direction;
};

constexpr double kNoHit = std::numeric_limits<double>::infinity();

/// In the body's own frame, centred: Box, Ellipsoid: half extents `size`; Cylinder (with caps),
/// Capsule: axis y, radius size.x, half height size.y (a capsule's includes its round ends).
enum class Shape { Box, Ellipsoid, Cylinder, Capsule };

/// A solid with a painted surface, metres. A ray that starts inside hits it from within, so that a
/// box may be a room. A value; all functions are pure.
struct Body {
    Shape shape = Shape::Box;
    calib::RigidTransform sceneFromBody;
    glm::dvec3 size{1.0};
    Material material;
};

/// Distance to the first hit in front of the ray's origin, or kNoHit.
[[nodiscard]] double intersect(const Body& body, const Ray& ray);

/// Outward normal (unit, body frame) at a point on the surface (body frame).
[[nodiscard]] glm::dvec3 normalAt(const Body& body, const glm::dvec3& point);

/// Half extents of the axis-parallel box around the body after turning it by `rotation`.
[[nodiscard]] glm::dvec3 extentsAfter(const Body& body, const glm::dmat3& rotation);

} // namespace autostereo::devices::sim
