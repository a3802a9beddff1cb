#include "devices/sim/body.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace autostereo::devices::sim {
namespace {

constexpr double kNearest = 1e-6; // keeps a ray from hitting the surface that it starts on

double nearestOf(double first, double second) {
    if (first > kNearest) return first;
    return second > kNearest ? second : kNoHit;
}

/// Where a ray is between two planes at +-half; empty (first > second) where it never is.
struct Interval {
    double first = -kNoHit;
    double second = kNoHit;
};

Interval slab(double origin, double direction, double half) {
    if (direction == 0.0) return std::abs(origin) <= half ? Interval{} : Interval{kNoHit, -kNoHit};
    const double a = (-half - origin) / direction;
    const double b = (half - origin) / direction;
    return a < b ? Interval{a, b} : Interval{b, a};
}

Interval overlap(const Interval& a, const Interval& b) {
    return {std::max(a.first, b.first), std::min(a.second, b.second)};
}

double nearestOf(const Interval& inside) {
    return inside.first <= inside.second ? nearestOf(inside.first, inside.second) : kNoHit;
}

double hitBox(const Ray& ray, const glm::dvec3& size) {
    Interval inside = slab(ray.origin.x, ray.direction.x, size.x);
    inside = overlap(inside, slab(ray.origin.y, ray.direction.y, size.y));
    inside = overlap(inside, slab(ray.origin.z, ray.direction.z, size.z));
    return nearestOf(inside);
}

/// Roots of a t^2 + 2 b t + c <= 0.
Interval solve(double a, double b, double c) {
    const double discriminant = b * b - a * c;
    if (discriminant < 0.0 || a == 0.0) return {kNoHit, -kNoHit};
    const double root = std::sqrt(discriminant);
    return {(-b - root) / a, (-b + root) / a};
}

Interval insideSphere(const glm::dvec3& origin, const glm::dvec3& direction, double radius) {
    return solve(glm::dot(direction, direction), glm::dot(origin, direction),
                 glm::dot(origin, origin) - radius * radius);
}

Interval insideTube(const Ray& ray, double radius) {
    const double a = ray.direction.x * ray.direction.x + ray.direction.z * ray.direction.z;
    const double c = ray.origin.x * ray.origin.x + ray.origin.z * ray.origin.z - radius * radius;
    if (a == 0.0) return c <= 0.0 ? Interval{} : Interval{kNoHit, -kNoHit};
    return solve(a, ray.origin.x * ray.direction.x + ray.origin.z * ray.direction.z, c);
}

double hitCylinder(const Ray& ray, const glm::dvec3& size) {
    return nearestOf(overlap(insideTube(ray, size.x), slab(ray.origin.y, ray.direction.y, size.y)));
}

/// The union of a tube and two balls; convex, so the ray is inside from the first to the last.
double hitCapsule(const Ray& ray, const glm::dvec3& size) {
    const Interval around = insideTube(ray, size.x);
    if (around.first > around.second) return kNoHit;
    const double straight = size.y - size.x;
    Interval whole = overlap(around, slab(ray.origin.y, ray.direction.y, straight));
    if (whole.first > whole.second) whole = {kNoHit, -kNoHit};
    for (const double end : {-straight, straight}) {
        const Interval ball =
            insideSphere(ray.origin - glm::dvec3(0, end, 0), ray.direction, size.x);
        if (ball.first > ball.second) continue;
        whole = {std::min(whole.first, ball.first), std::max(whole.second, ball.second)};
    }
    return nearestOf(whole);
}

} // namespace

double intersect(const Body& body, const Ray& ray) {
    const auto& [rotation, centre] = body.sceneFromBody;
    // v * M is transpose(M) * v: into the body's frame.
    const Ray local{(ray.origin - centre) * rotation, ray.direction * rotation};
    switch (body.shape) {
    case Shape::Box:
        return hitBox(local, body.size);
    case Shape::Cylinder:
        return hitCylinder(local, body.size);
    case Shape::Capsule:
        return hitCapsule(local, body.size);
    case Shape::Ellipsoid:
        break;
    }
    return nearestOf(insideSphere(local.origin / body.size, local.direction / body.size, 1.0));
}

glm::dvec3 normalAt(const Body& body, const glm::dvec3& point) {
    const glm::dvec3 relative = point / body.size;
    const glm::dvec3 away = glm::abs(relative);
    switch (body.shape) {
    case Shape::Box:
        if (away.x >= away.y && away.x >= away.z) return {std::copysign(1.0, point.x), 0, 0};
        if (away.y >= away.z) return {0, std::copysign(1.0, point.y), 0};
        return {0, 0, std::copysign(1.0, point.z)};
    case Shape::Cylinder:
        if (away.y * body.size.x >= std::hypot(point.x, point.z)) {
            return {0, std::copysign(1.0, point.y), 0};
        }
        return glm::normalize(glm::dvec3(point.x, 0, point.z));
    case Shape::Capsule: {
        const double straight = body.size.y - body.size.x;
        return glm::normalize(point - glm::dvec3(0, std::clamp(point.y, -straight, straight), 0));
    }
    case Shape::Ellipsoid:
        break;
    }
    return glm::normalize(relative / body.size);
}

glm::dvec3 extentsAfter(const Body& body, const glm::dmat3& rotation) {
    const bool round = body.shape == Shape::Cylinder || body.shape == Shape::Capsule;
    const glm::dvec3 half = round ? glm::dvec3(body.size.x, body.size.y, body.size.x) : body.size;
    glm::dvec3 extents(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        const glm::dvec3 side = glm::abs(rotation[axis]) * half[axis];
        extents += body.shape == Shape::Ellipsoid ? side * side : side;
    }
    return body.shape == Shape::Ellipsoid ? glm::sqrt(extents) : extents;
}

} // namespace autostereo::devices::sim
