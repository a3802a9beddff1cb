#include "devices/sim/person.hpp"

#include "devices/sim/placement.hpp"

#include <cmath>

namespace autostereo::devices::sim {
namespace {

const Material kSkin{plain, {232, 178, 146}, 0.62, 0, 0};
const Material kFace{face, {232, 178, 146}, 0.62, 0, 0};
const Material kHair{hair, {92, 58, 36}, 0.16, 0, 7};
const Material kShirt{stripes, {42, 84, 128}, 0.55, 0, 8};
const Material kSleeve{plain, {42, 84, 128}, 0.55, 0, 8};
const Material kTrousers{mottled, {66, 62, 70}, 0.40, 0, 9};

/// sin of so many whole turns in the person's period.
double wave(double timeSeconds, int turns, double phase = 0) {
    constexpr double kTwoPi = 6.283185307179586;
    return std::sin(kTwoPi * (turns * timeSeconds / kPersonPeriodS + phase));
}

Body limb(const glm::dvec3& from, const glm::dvec3& to, double radius, const Material& material) {
    const double half = 0.5 * glm::length(to - from) + radius;
    return {Shape::Capsule, between(from, to), {radius, half, radius}, material};
}

void addHead(std::vector<Body>& bodies, const glm::dvec3& neck, double time) {
    const glm::dmat3 pose =
        turn(0.30 * wave(time, 1, 0.1), {0, 1, 0}) * turn(0.07 * wave(time, 2, 0.3), {0, 0, 1});
    const glm::dvec3 centre = neck + pose * glm::dvec3(0, -0.150, -0.015);
    const auto add = [&](const glm::dvec3& at, const glm::dvec3& size, const Material& material) {
        bodies.push_back({Shape::Ellipsoid, {pose, centre + pose * at}, size, material});
    };
    bodies.push_back(
        limb(neck + glm::dvec3(0, 0.04, 0.01), neck + glm::dvec3(0, -0.07, 0), 0.052, kSkin));
    add({0, 0, 0}, {0.078, 0.112, 0.094}, kFace);
    add({0, 0.022, -0.092}, {0.013, 0.019, 0.018}, kSkin);
    for (const double side : {-1.0, 1.0}) {
        add({side * 0.079, 0.012, 0.008}, {0.012, 0.028, 0.018}, kSkin);
    }
    add({0, -0.036, 0.024}, {0.088, 0.098, 0.098}, kHair);
    add({0.018, -0.092, -0.042}, {0.062, 0.036, 0.050}, kHair);
}

void addArm(std::vector<Body>& bodies, const glm::dvec3& shoulder, const glm::dvec3& elbow,
            const glm::dvec3& wrist) {
    bodies.push_back(limb(shoulder, elbow, 0.052, kSleeve));
    bodies.push_back(limb(elbow, wrist, 0.038, kSkin));
    const glm::dvec3 hand = wrist + 0.075 * glm::normalize(wrist - elbow);
    calib::RigidTransform pose = between(elbow, wrist);
    pose.translation = hand;
    bodies.push_back({Shape::Ellipsoid, pose, {0.045, 0.085, 0.024}, kSkin});
    const glm::dvec3 thumb = hand + pose.rotation * glm::dvec3(-0.062, 0.012, 0);
    bodies.push_back(limb(wrist, thumb, 0.012, kSkin));
}

} // namespace

std::vector<Body> personAt(double timeSeconds) {
    const double t = timeSeconds;
    const glm::dvec3 hip{-0.27 + 0.03 * wave(t, 1), 0.38, 1.47};
    const glm::dvec3 chest =
        hip + glm::dvec3(0.03 * wave(t, 1, -0.04), -0.36, -0.03 + 0.03 * wave(t, 1, 0.25));
    std::vector<Body> bodies;
    bodies.reserve(20);

    // Chest and waist lie two stripes apart, so that the shirt's pattern goes through.
    const glm::dmat3 lean = between(hip, chest).rotation;
    const auto add = [&](double below, const glm::dvec3& size, const Material& material) {
        const glm::dvec3 centre = chest - below * lean[1];
        bodies.push_back({Shape::Ellipsoid, {lean, centre}, size, material});
    };
    add(0.00, {0.200, 0.170, 0.115}, kShirt);
    add(0.14, {0.172, 0.290, 0.112}, kShirt);
    add(0.38, {0.172, 0.105, 0.120}, kTrousers);
    for (const double side : {-1.0, 1.0}) {
        const glm::dvec3 thigh = hip + glm::dvec3(side * 0.085, 0.06, 0);
        bodies.push_back(limb(thigh, {-0.27 + side * 0.11, 1.03, 1.49}, 0.082, kTrousers));
    }
    addHead(bodies, chest + glm::dvec3(0, -0.13, 0), t);

    // Image right: hangs, swinging a little. Image left: waves, and reaches towards the camera.
    const glm::dvec3 right = chest + glm::dvec3(0.205, -0.03, 0);
    addArm(bodies, right, right + glm::dvec3(0.055, 0.27, 0.02),
           right + glm::dvec3(0.05, 0.48, -0.05 + 0.04 * wave(t, 1, 0.2)));
    const glm::dvec3 left = chest + glm::dvec3(-0.205, -0.03, 0);
    const double reach = 0.5 + 0.5 * wave(t, 1, 0.6);
    const glm::dvec3 elbow = left + glm::dvec3(-0.09, 0.17 - 0.06 * reach, -0.10 - 0.10 * reach);
    const glm::dvec3 forearm{0.04 + 0.12 * wave(t, 4), -0.20, -0.06 - 0.10 * reach};
    addArm(bodies, left, elbow, elbow + 0.25 * glm::normalize(forearm));
    return bodies;
}

} // namespace autostereo::devices::sim
