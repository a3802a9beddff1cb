#include "calib/rigid_transform.hpp"
#include "tests/unit/calib/random_numbers.hpp"

#include <gtest/gtest.h>

namespace autostereo::calib {
namespace {

constexpr double kSame = 1e-12; // metres; rotations of points a few metres away, in double

TEST(RigidTransform, RotatesThenMoves) {
    // A quarter turn about z (x to y), columns first as GLM has it.
    const RigidTransform turned{{0, 1, 0, -1, 0, 0, 0, 0, 1}, {10, 20, 30}};
    const glm::dvec3 p = turned * glm::dvec3{1, 2, 3};
    EXPECT_EQ(p, (glm::dvec3{8, 21, 33}));
    EXPECT_EQ((RigidTransform{} * glm::dvec3{1, 2, 3}), (glm::dvec3{1, 2, 3}));
}

TEST(RigidTransform, InverseTakesBack) {
    RandomNumbers random(4);
    for (int i = 0; i < 200; ++i) {
        const RigidTransform there = random.pose(3, 2);
        const glm::dvec3 p = random.vectorWithin(5);
        EXPECT_GT(glm::length(there * p - p), 0);
        EXPECT_LT(glm::length(there.inverse() * (there * p) - p), kSame);
        EXPECT_LT(glm::length(there * (there.inverse() * p) - p), kSame);
    }
}

TEST(RigidTransform, ChainsFromRightToLeft) {
    RandomNumbers random(5);
    for (int i = 0; i < 200; ++i) {
        const RigidTransform cFromB = random.pose(3, 2), bFromA = random.pose(3, 2);
        const glm::dvec3 p = random.vectorWithin(5);
        const RigidTransform cFromA = cFromB * bFromA;
        EXPECT_LT(glm::length(cFromA * p - cFromB * (bFromA * p)), kSame);
        EXPECT_GT(glm::length(cFromA * p - bFromA * (cFromB * p)), 1e-3);
        const RigidTransform aFromC = bFromA.inverse() * cFromB.inverse();
        EXPECT_LT(glm::length(aFromC * p - cFromA.inverse() * p), kSame);
    }
}

} // namespace
} // namespace autostereo::calib
