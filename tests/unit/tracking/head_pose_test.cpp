#include "devices/tracking/head_pose.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <numbers>

namespace autostereo::test {
namespace {

using devices::eyesOf;
using devices::TrackerPose;

constexpr double kDegree = std::numbers::pi / 180;
constexpr glm::dvec3 kNominalHead{0, 0, 0.65};

void expectAt(const glm::dvec3& found, const glm::dvec3& expected) {
    EXPECT_NEAR(glm::length(found - expected), 0, 1e-12)
        << found.x << ' ' << found.y << ' ' << found.z;
}

TEST(HeadPose, CentredHeadsLookFromTheNominalPlace) {
    const auto eyes = eyesOf({}, {}, kNominalHead, 0.064);
    expectAt(eyes.left, {-0.032, 0, 0.65});
    expectAt(eyes.right, {0.032, 0, 0.65});
}

TEST(HeadPose, ForwardIsToThePanelRightAndUpAreTheViewers) {
    const auto eyes = eyesOf({{0.1, 0.02, 0.05}, 0, 0, 0}, {}, kNominalHead, 0.064);
    expectAt(eyes.middle(), {0.1, 0.02, 0.6});
}

TEST(HeadPose, ATurnedOrTiltedHeadMovesItsEyes) {
    const double s = 0.032;
    // To the viewer's right: the right eye goes back, away from the panel.
    const auto turned = eyesOf({{}, 30 * kDegree, 0, 0}, {}, kNominalHead, 2 * s);
    expectAt(turned.right - turned.left,
             2 * s * glm::dvec3{std::cos(30 * kDegree), 0, std::sin(30 * kDegree)});
    // Ear to the right shoulder: the right eye goes down.
    const auto leant = eyesOf({{}, 0, 0, 20 * kDegree}, {}, kNominalHead, 2 * s);
    expectAt(leant.right - leant.left,
             2 * s * glm::dvec3{std::cos(20 * kDegree), -std::sin(20 * kDegree), 0});
    const auto nodding = eyesOf({{}, 0, 40 * kDegree, 0}, {}, kNominalHead, 2 * s);
    expectAt(nodding.right, {s, 0, 0.65});
    TrackerPose blind;
    blind.angleScale = {0, 0, 0};
    expectAt(eyesOf({{}, 1, 1, 1}, blind, kNominalHead, 2 * s).right, {s, 0, 0.65});
}

TEST(HeadPose, ATrackerStandsWhereItsPoseSays) {
    TrackerPose tracker;
    tracker.originM = glm::dvec3{0, 0.25, 0};
    tracker.scale = {-1, 1, 1};                 // a camera's own mirror image
    tracker.rotationRad = {20 * kDegree, 0, 0}; // looks down: z' leans from z to -y
    const double distance = 0.7;
    const auto eyes = eyesOf({{-0.1, 0, distance}, 0, 0, 0}, tracker, kNominalHead, 0.06);
    expectAt(eyes.middle(),
             {0.1, 0.25 - distance * std::sin(20 * kDegree), distance * std::cos(20 * kDegree)});
    tracker.rotationRad = {0, 90 * kDegree, 0}; // z' is x
    expectAt(eyesOf({{0, 0, 1}, 0, 0, 0}, tracker, kNominalHead, 0.06).middle(), {1, 0.25, 0});
    tracker.rotationRad = {0, 0, 90 * kDegree}; // x' is y
    expectAt(eyesOf({{-1, 0, 0}, 0, 0, 0}, tracker, kNominalHead, 0.06).middle(), {0, 1.25, 0});
}

} // namespace
} // namespace autostereo::test
