// A scene's place in display space: in the middle, within the panel, within the depth budget.

#include "calib/disparity_law.hpp"
#include "gpu/scene/scene_placement.hpp"

#include <gtest/gtest.h>

#include <glm/vec4.hpp>

#include <cmath>
#include <numbers>

namespace autostereo::test {
namespace {

calib::DisplayProfile display(double budget) {
    calib::DisplayProfile profile;
    profile.widthM = 0.4;
    profile.viewingDistanceM = 1;
    profile.coneRad = 0.6;
    profile.disparityFar = -budget;
    profile.disparityNear = budget;
    return profile;
}

devices::mesh::MeshExtent boxOf(const glm::dvec3& middle, const glm::dvec3& half) {
    return {middle - half, middle + half, std::hypot(half.x, half.z)};
}

struct Reach {
    double x = 0, y = 0, z = 0;
};

/// How far the box's corners ever come, in steps of a degree.
Reach reachOf(const devices::mesh::MeshExtent& box, const gpu::ScenePlacement& placement,
              const gpu::SceneParams& params) {
    Reach reach;
    for (int degree = 0; degree < 360; ++degree) {
        const glm::dmat4 way = placement.transform(params, params.turnS * degree / 360);
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec4 own{corner % 2 == 0 ? box.low.x : box.high.x,
                                 corner / 2 % 2 == 0 ? box.low.y : box.high.y,
                                 corner / 4 == 0 ? box.low.z : box.high.z, 1};
            const glm::dvec4 place = way * own;
            reach = {std::max(reach.x, std::abs(place.x)), std::max(reach.y, std::abs(place.y)),
                     std::max(reach.z, std::abs(place.z))};
        }
    }
    return reach;
}

TEST(ScenePlacement, SpansItsShareOfThePanelHoweverItIsTurned) {
    const gpu::SceneParams params{.share = 0.8};
    for (const auto& half : {glm::dvec3(3, 1, 2), {1, 5, 1}, {0.01, 0.02, 0.01}, {4, 0, 4}}) {
        const glm::dvec3 middle{100, -7, 3};
        const devices::mesh::MeshExtent box = boxOf(middle, half);
        for (const double aspect : {0.75, 1.0, 16.0 / 9}) {
            const auto placement = gpu::scenePlacement(box, params, display(0.05), aspect);
            const Reach reach = reachOf(box, placement, params);
            const double across = 2 * reach.x / 0.4, along = 2 * reach.y / (0.4 / aspect);
            // The widest turn may lie between two degrees: 1 - cos of half a degree.
            EXPECT_NEAR(std::max(across, along), 0.8, 1e-4);
            const glm::dvec4 centre = placement.transform(params, 5) * glm::dvec4(middle, 1);
            EXPECT_NEAR(std::abs(centre.x) + std::abs(centre.y) + std::abs(centre.z), 0, 1e-12);
        }
    }
}

TEST(ScenePlacement, StaysWithinTheDepthBudget) {
    const gpu::SceneParams params;
    const devices::mesh::MeshExtent box = boxOf(glm::dvec3(0), glm::dvec3(1));
    for (const double budget : {0.002, 0.02, 0.2}) {
        const calib::DisplayProfile profile = display(budget);
        const auto placement = gpu::scenePlacement(box, params, profile, 1.5);
        const double height = reachOf(box, placement, params).z * placement.flattening;
        EXPECT_LE(height, placement.nearM * (1 + 1e-12));
        const calib::DisparityLaw law = calib::disparityLaw(profile, 0, 1, 1);
        const double bx = calib::fanHalfWidth(profile);
        EXPECT_LE(bx * height / (1 - height), budget + 1e-12);
        EXPECT_GE(-bx * height / (1 + height), -budget - 1e-12);
        EXPECT_LE(height, law.heightAt(budget) + 1e-12);
        EXPECT_EQ(placement.flattening < 1, budget < 0.1) << budget;
    }
}

TEST(ScenePlacement, TurnsOnceInItsTimeAndLeansTowardTheViewer) {
    gpu::SceneParams params{.turnS = 8, .tiltRad = 0};
    const devices::mesh::MeshExtent box = boxOf(glm::dvec3(0), glm::dvec3(1));
    const auto placement = gpu::scenePlacement(box, params, display(0.05), 1);
    const auto at = [&](double seconds, const glm::dvec3& own) {
        return glm::dvec3(placement.transform(params, seconds) * glm::dvec4(own, 1)) /
               placement.scale;
    };
    EXPECT_NEAR(at(2, {0, 0, 1}).x, 1, 1e-12) << "what was in front goes to the right";
    EXPECT_NEAR(at(8, {1, 0, 0}).x, 1, 1e-12);
    EXPECT_NEAR(at(-2, {0, 0, 1}).x, -1, 1e-12);
    params.tiltRad = 0.3;
    EXPECT_GT(at(0, {0, 1, 0}).z, 0.2);
    params.turnS = 0;
    params.tiltRad = 0;
    EXPECT_EQ(at(3, {1, 0, 0}), at(0, {1, 0, 0}));
    params.up = gpu::SceneUp::Z;
    EXPECT_NEAR(at(0, {0, 0, 1}).y, 1, 1e-12);
    EXPECT_NEAR(at(0, {0, -1, 0}).z, 1, 1e-12) << "and its front, -y, to the viewer";
}

} // namespace
} // namespace autostereo::test
