#include "devices/tracking/eye_source.hpp"

#include <glm/common.hpp>

#include <cmath>

namespace autostereo::devices {

namespace {

constexpr double kNearestM = 0.1, kFarthestM = 10;

bool isPlace(const glm::dvec3& eye) {
    // NaN fails every comparison.
    return std::abs(eye.x) <= kFarthestM && std::abs(eye.y) <= kFarthestM && eye.z >= kNearestM &&
           eye.z <= kFarthestM;
}

glm::dvec3 clampedPlace(const glm::dvec3& eye) {
    return glm::clamp(eye, glm::dvec3{-kFarthestM, -kFarthestM, kNearestM}, glm::dvec3{kFarthestM});
}

} // namespace

bool isPlausible(const calib::EyePair& eyes) { return isPlace(eyes.left) && isPlace(eyes.right); }

calib::EyePair clamped(const calib::EyePair& eyes) {
    return {clampedPlace(eyes.left), clampedPlace(eyes.right)};
}

} // namespace autostereo::devices
