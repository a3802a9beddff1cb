#include "devices/sim/body.hpp"
#include "devices/sim/hash.hpp"
#include "devices/sim/placement.hpp"

#include <glm/common.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace autostereo::devices::sim {
namespace {

/// Uniform in [-1, 1]^3.
glm::dvec3 randomVector(std::uint64_t key, std::uint64_t counter) {
    const auto value = [&](std::uint64_t axis) {
        return 2 * uniformFrom(hashBits(key, 3 * counter + axis)) - 1;
    };
    return {value(0), value(1), value(2)};
}

/// Negative inside the body, written from the definition of each shape (body frame).
double insideness(const Body& body, const glm::dvec3& p) {
    const glm::dvec3 size = body.size;
    const double radial = std::hypot(p.x, p.z);
    switch (body.shape) {
    case Shape::Box: {
        const glm::dvec3 over = glm::abs(p) - size;
        return std::max({over.x, over.y, over.z});
    }
    case Shape::Ellipsoid:
        return glm::length(p / size) - 1;
    case Shape::Cylinder:
        return std::max(radial - size.x, std::abs(p.y) - size.y);
    case Shape::Capsule:
        break;
    }
    const double beyond = std::max(std::abs(p.y) - (size.y - size.x), 0.0);
    return std::hypot(radial, beyond) - size.x;
}

class BodyOfShape : public ::testing::TestWithParam<Shape> {
  protected:
    Body solid{GetParam(),
               {turn(0.7, glm::normalize(glm::dvec3(1, 2, 3))), {0.3, -0.2, 0.5}},
               {0.2, 0.5, 0.35},
               {}};
    [[nodiscard]] double insidenessAt(const glm::dvec3& scenePoint) const {
        return insideness(solid, solid.sceneFromBody.inverse() * scenePoint);
    }
};

// The first crossing of the surface, found by small steps along the ray, is what the closed form
// says. Rays that only graze (the walk never gets deeper than a step) are left out.
TEST_P(BodyOfShape, FirstHitAgreesWithWalkingAlongTheRay) {
    constexpr double kStep = 1e-3;
    int hits = 0, misses = 0;
    for (std::uint64_t i = 0; i < 250; ++i) {
        const glm::dvec3 origin = solid.sceneFromBody.translation + 1.2 * randomVector(1, i);
        const glm::dvec3 aim = solid.sceneFromBody.translation + 0.6 * randomVector(2, i);
        const glm::dvec3 direction = glm::normalize(aim - origin);
        const bool startsInside = insidenessAt(origin) < 0;
        double walked = kNoHit, deepest = 1;
        for (int step = 1; step < 4000; ++step) {
            const double t = kStep * step;
            const double at = insidenessAt(origin + t * direction);
            if (walked == kNoHit && (at < 0) != startsInside) walked = t;
            deepest = std::min(deepest, at);
        }
        if (std::abs(deepest) < 2 * kStep) continue;
        const double found = BodyFromPoint(solid, origin).distanceAlong(direction);
        if (walked == kNoHit) {
            EXPECT_EQ(found, kNoHit) << "ray " << i;
            ++misses;
        } else {
            EXPECT_NEAR(found, walked, 2 * kStep) << "ray " << i;
            ++hits;
        }
    }
    EXPECT_GT(hits, 60);
    EXPECT_GT(misses, 40);
}

// The normal is the direction in which the insideness grows fastest.
TEST_P(BodyOfShape, NormalPointsOutOfTheSurface) {
    int tested = 0;
    for (std::uint64_t i = 0; i < 300; ++i) {
        const glm::dvec3 origin = solid.sceneFromBody.translation + 2.0 * randomVector(3, i);
        const glm::dvec3 direction =
            solid.sceneFromBody.translation - origin + 0.1 * randomVector(4, i);
        const double distance = BodyFromPoint(solid, origin).distanceAlong(direction);
        if (distance == kNoHit) continue;
        const glm::dvec3 point = solid.sceneFromBody.inverse() * (origin + distance * direction);
        const glm::dvec3 normal = normalAt(solid, point);
        EXPECT_NEAR(glm::length(normal), 1.0, 1e-12);
        constexpr double kSmall = 1e-6;
        EXPECT_GT(insideness(solid, point + kSmall * normal), 0) << "ray " << i;
        EXPECT_LT(insideness(solid, point - kSmall * normal), 0) << "ray " << i;
        ++tested;
    }
    EXPECT_GT(tested, 200);
}

TEST_P(BodyOfShape, ExtentsEncloseTheSurface) {
    const glm::dvec3 half = extentsAfter(solid, solid.sceneFromBody.rotation);
    for (std::uint64_t i = 0; i < 300; ++i) {
        const glm::dvec3 centre = solid.sceneFromBody.translation;
        const glm::dvec3 direction = randomVector(5, i);
        const double out = BodyFromPoint(solid, centre).distanceAlong(direction);
        const glm::dvec3 away = glm::abs(out * direction);
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_LE(away[axis], half[axis] + 1e-12);
    }
}

INSTANTIATE_TEST_SUITE_P(Shapes, BodyOfShape,
                         ::testing::Values(Shape::Box, Shape::Ellipsoid, Shape::Cylinder,
                                           Shape::Capsule));

// Along the axis the tube has no first and last point.
TEST(Capsule, IsHitAlongItsAxis) {
    const Body capsule{Shape::Capsule, {}, {0.1, 0.4, 0.1}, {}};
    EXPECT_DOUBLE_EQ(BodyFromPoint(capsule, {0, -1, 0}).distanceAlong({0, 1, 0}), 0.6);
    EXPECT_DOUBLE_EQ(BodyFromPoint(capsule, {0, 1, 0}).distanceAlong({0, -2, 0}), 0.3);
    EXPECT_DOUBLE_EQ(BodyFromPoint(capsule, {0, 0, 0}).distanceAlong({0, 1, 0}), 0.4);
    EXPECT_EQ(BodyFromPoint(capsule, {0.2, -1, 0}).distanceAlong({0, 1, 0}), kNoHit);
}

} // namespace
} // namespace autostereo::devices::sim
