#include "devices/tracking/head_pose.hpp"

#include <cmath>

namespace autostereo::devices {

glm::dvec3 turned(glm::dvec3 v, const glm::dvec3& angles) {
    const auto turn = [](double& a, double& b, double angle) {
        const double cosine = std::cos(angle), sine = std::sin(angle), before = a;
        a = cosine * a - sine * b;
        b = sine * before + cosine * b;
    };
    turn(v.y, v.z, angles.x);
    turn(v.z, v.x, angles.y);
    turn(v.x, v.y, angles.z);
    return v;
}

calib::EyePair eyesOf(const HeadPose& head, const TrackerPose& tracker, const glm::dvec3& nominal,
                      double spacingM) {
    const double yaw = head.yawRad * tracker.angleScale.x;
    const double roll = head.rollRad * tracker.angleScale.z;
    const glm::dvec3 across{std::cos(yaw) * std::cos(roll), -std::sin(roll),
                            std::sin(yaw) * std::cos(roll)};
    const glm::dvec3 middle = tracker.originM.value_or(nominal) +
                              turned(head.positionM * tracker.scale, tracker.rotationRad);
    const glm::dvec3 half = turned(across, tracker.rotationRad) * (spacingM / 2);
    return {middle - half, middle + half};
}

} // namespace autostereo::devices
