#pragma once

#include "calib/camera_model.hpp"
#include "calib/rigid_transform.hpp"

#include <glm/gtc/quaternion.hpp>

#include <cstdint>
#include <random>

namespace autostereo::calib {

/// Seeded cameras and poses for tests that hold for all of them.
class RandomNumbers {
  public:
    explicit RandomNumbers(std::uint32_t seed) : engine_(seed) {}

    double between(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine_);
    }
    glm::dvec3 vectorWithin(double radius) {
        return {between(-radius, radius), between(-radius, radius), between(-radius, radius)};
    }
    /// Turned about any axis by at most `angle`, moved by at most `distance` along each axis.
    RigidTransform pose(double angle, double distance) {
        const glm::dvec3 axis = glm::normalize(vectorWithin(1) + glm::dvec3{0, 0, 2});
        const glm::dquat turn = glm::angleAxis(between(-angle, angle), axis);
        const glm::dquat tip = glm::angleAxis(between(-angle, angle) / 2, glm::dvec3{1, 0, 0});
        return {glm::mat3_cast(tip * turn), vectorWithin(distance)};
    }
    /// 320 to 3840 pixels wide, 37 to 90 degrees; all eight terms of the distortion, scaled.
    CameraModel camera(double bend) {
        CameraModel camera;
        Intrinsics& i = camera.intrinsics;
        i.width = static_cast<int>(between(320, 3840));
        i.height = static_cast<int>(between(0.55, 0.9) * i.width);
        i.fx = between(0.5, 1.5) * i.width;
        i.fy = between(0.98, 1.02) * i.fx;
        i.cx = between(0.45, 0.55) * i.width;
        i.cy = between(0.45, 0.55) * i.height;
        Distortion& k = camera.distortion;
        k.k1 = bend * between(-0.3, 0.3);
        k.k2 = bend * between(-0.1, 0.1);
        k.k3 = bend * between(-0.03, 0.03);
        k.p1 = bend * between(-0.005, 0.005);
        k.p2 = bend * between(-0.005, 0.005);
        k.k4 = bend * between(0, 0.2); // the denominator of a real lens has no root
        k.k5 = bend * between(0, 0.1);
        k.k6 = bend * between(0, 0.03);
        return camera;
    }

  private:
    std::mt19937 engine_;
};

} // namespace autostereo::calib
