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

constexpr Interval kNever{kNoHit, -kNoHit};

Interval slab(double origin, double direction, double half) {
    if (direction == 0.0) return std::abs(origin) <= half ? Interval{} : kNever;
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

/// Where a t^2 + 2 b t + c <= 0.
Interval solve(double a, double b, double c) {
    const double discriminant = b * b - a * c;
    if (discriminant < 0.0 || a == 0.0) return kNever;
    const double root = std::sqrt(discriminant);
    return {(-b - root) / a, (-b + root) / a};
}

Interval insideBall(const glm::dvec3& origin, const glm::dvec3& direction, double radius) {
    return solve(glm::dot(direction, direction), glm::dot(origin, direction),
                 glm::dot(origin, origin) - radius * radius);
}

/// An endless cylinder around the y axis.
Interval insideTube(const glm::dvec3& origin, const glm::dvec3& direction, double radius) {
    const double a = direction.x * direction.x + direction.z * direction.z;
    const double c = origin.x * origin.x + origin.z * origin.z - radius * radius;
    if (a == 0.0) return c <= 0.0 ? Interval{} : kNever;
    return solve(a, origin.x * direction.x + origin.z * direction.z, c);
}

} // namespace

BodyFromPoint::BodyFromPoint(const Body& body, const glm::dvec3& origin)
    : shape_(body.shape), size_(body.size),
      localFromScene_(glm::transpose(body.sceneFromBody.rotation)) {
    if (shape_ == Shape::Ellipsoid) {
        for (int axis = 0; axis < 3; ++axis)
            localFromScene_[axis] /= size_;
    }
    origin_ = localFromScene_ * (origin - body.sceneFromBody.translation);
}

double BodyFromPoint::distanceAlong(const glm::dvec3& direction) const {
    const glm::dvec3 local = localFromScene_ * direction;
    switch (shape_) {
    case Shape::Box:
        return toBox(local);
    case Shape::Cylinder:
        return toCylinder(local);
    case Shape::Capsule:
        return toCapsule(local);
    case Shape::Ellipsoid:
        break;
    }
    return nearestOf(insideBall(origin_, local, 1.0));
}

double BodyFromPoint::toBox(const glm::dvec3& direction) const {
    Interval inside = slab(origin_.x, direction.x, size_.x);
    inside = overlap(inside, slab(origin_.y, direction.y, size_.y));
    inside = overlap(inside, slab(origin_.z, direction.z, size_.z));
    return nearestOf(inside);
}

double BodyFromPoint::toCylinder(const glm::dvec3& direction) const {
    return nearestOf(
        overlap(insideTube(origin_, direction, size_.x), slab(origin_.y, direction.y, size_.y)));
}

/// A line that goes through the tube beyond its straight part can only pass the end there.
double BodyFromPoint::toCapsule(const glm::dvec3& direction) const {
    const Interval tube = insideTube(origin_, direction, size_.x);
    if (tube.first > tube.second) return kNoHit;
    const double straight = size_.y - size_.x;
    const auto roundEnd = [&](double height) {
        const glm::dvec3 middle(0, std::copysign(straight, height), 0);
        return insideBall(origin_ - middle, direction, size_.x);
    };
    const double enters = origin_.y + tube.first * direction.y;
    const double leaves = origin_.y + tube.second * direction.y;
    const double first = std::abs(enters) <= straight ? tube.first : roundEnd(enters).first;
    if (first > kNearest) return first; // kNoHit, too: it passes the end without touching it
    return nearestOf(first, std::abs(leaves) <= straight ? tube.second : roundEnd(leaves).second);
}

glm::dvec3 normalAt(const Body& body, const glm::dvec3& point) {
    switch (body.shape) {
    case Shape::Box: {
        const glm::dvec3 away = glm::abs(point / body.size);
        if (away.x >= away.y && away.x >= away.z) return {std::copysign(1.0, point.x), 0, 0};
        if (away.y >= away.z) return {0, std::copysign(1.0, point.y), 0};
        return {0, 0, std::copysign(1.0, point.z)};
    }
    case Shape::Cylinder:
        if (std::abs(point.y) * body.size.x >= std::hypot(point.x, point.z) * body.size.y) {
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
    return glm::normalize(point / (body.size * body.size));
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
