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

/// A body seen from one point: what does not depend on a ray's direction is computed once.
class BodyFromPoint {
  public:
    BodyFromPoint(const Body& body, const glm::dvec3& origin);
    /// To the first hit in front of the origin, or kNoHit.
    [[nodiscard]] double distanceAlong(const glm::dvec3& direction) const;

  private:
    [[nodiscard]] double toBox(const glm::dvec3& direction) const;
    [[nodiscard]] double toCylinder(const glm::dvec3& direction) const;
    [[nodiscard]] double toCapsule(const glm::dvec3& direction) const;

    Shape shape_;
    glm::dvec3 size_;
    glm::dmat3 localFromScene_; ///< also scales an ellipsoid to a ball of radius 1
    glm::dvec3 origin_;         ///< local
};

/// Outward normal (unit, body frame) at a point on the surface (body frame).
[[nodiscard]] glm::dvec3 normalAt(const Body& body, const glm::dvec3& point);

/// Half extents of the axis-parallel box around the body after turning it by `rotation`.
[[nodiscard]] glm::dvec3 extentsAfter(const Body& body, const glm::dmat3& rotation);

} // namespace autostereo::devices::sim
