// Pupils in a picture to eyes in display space, against what was projected.

#include "devices/frame_pool.hpp"
#include "devices/tracking/eye_place.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace autostereo::test {
namespace {

using namespace devices;

calib::CameraModel camera() {
    calib::CameraModel model;
    model.intrinsics = {640, 480, 554, 560, 317, 243};
    model.distortion.k1 = -0.08;
    model.distortion.k2 = 0.02;
    return model;
}

/// Eyes of somebody at `middle` who looks at the camera, leant by `roll`.
calib::EyePair looking(const glm::dvec3& middle, double roll, double spacing) {
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3{0, 1, 0}, middle));
    const glm::dvec3 down = glm::normalize(glm::cross(middle, right));
    const glm::dvec3 half = (std::cos(roll) * right + std::sin(roll) * down) * (spacing / 2);
    return {middle + half, middle - half};
}

double apart(const calib::EyePair& a, const calib::EyePair& b) {
    return std::max(glm::length(a.left - b.left), glm::length(a.right - b.right));
}

TEST(EyePlace, SpacingGivesTheDistanceOfWhoLooksAtTheCamera) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> x(-0.3, 0.3), z(0.4, 2), roll(-0.4, 0.4);
    for (int i = 0; i < 100; ++i) {
        const calib::EyePair eyes = looking({x(random), x(random), z(random)}, roll(random), 0.06);
        const auto left = camera().project(eyes.left), right = camera().project(eyes.right);
        ASSERT_TRUE(left && right);
        const auto found = eyesBySpacing(camera(), {*left, *right}, 0.06);
        ASSERT_TRUE(found);
        // The model is inverted to 1e-9 or so of a direction, of which 2 m over 60 mm make 33
        // times.
        EXPECT_LT(apart(*found, eyes), 1e-6);
        const calib::EyePair moved = movedTo(*found, 2 * eyes.middle().z);
        EXPECT_NEAR(moved.middle().z, 2 * eyes.middle().z, 1e-6);
        EXPECT_LT(glm::length(*camera().project(moved.left) - *left), 1e-3);
    }
    EXPECT_FALSE(eyesBySpacing(camera(), {{100, 100}, {100, 100}}, 0.06));
}

TEST(EyePlace, ACameraOnThePanelSeesTheViewersLeftOnItsRight) {
    const calib::EyePair seen{{0.13, -0.05, 0.7}, {0.07, -0.05, 0.7}};
    TrackerPose pose;
    const auto near = [](const glm::dvec3& a, const glm::dvec3& b) {
        return glm::length(a - b) < 1e-12;
    };
    EXPECT_TRUE(near(inDisplaySpace(seen, pose).left, {-0.13, 0.05, 0.7}));
    EXPECT_TRUE(near(inDisplaySpace(seen, pose).right, {-0.07, 0.05, 0.7}));
    pose.originM = glm::dvec3{0, 0.2, 0.01};
    EXPECT_TRUE(near(inDisplaySpace(seen, pose).left, {-0.13, 0.25, 0.71}));
    // Turned down by a right angle, what is before it is below.
    pose.rotationRad = {std::acos(-1.0) / 2, 0, 0};
    EXPECT_TRUE(near(inDisplaySpace(seen, pose).left, {-0.13, 0.2 - 0.7, 0.01 + 0.05}));
}

class MeasuredDepth : public testing::Test {
  protected:
    MeasuredDepth() {
        rig.color = camera();
        rig.depth.intrinsics = {320, 288, 260, 260, 161, 142};
        const double turn = 0.1;
        rig.colorFromDepth = {
            {{std::cos(turn), 0, -std::sin(turn)}, {0, 1, 0}, {std::sin(turn), 0, std::cos(turn)}},
            {-0.04, 0.01, 0.04}};
    }
    /// A ball about the eyes before a wall: the depth camera's picture, each ray on its own.
    Frame ball(const glm::dvec3& middle, double radius) {
        FrameMetadata form;
        form.format = PixelFormat::Depth16;
        form.width = 320;
        form.height = 288;
        form.depthUnitM = 0.00025;
        Frame frame = std::move(*pool.acquire(form));
        const glm::dvec3 centre = rig.colorFromDepth.inverse() * middle;
        for (int i = 0; i < 320 * 288; ++i) {
            const glm::dvec3 ray{*rig.depth.unproject({i % 320, i / 320}), 1};
            const double a = glm::dot(ray, ray), b = glm::dot(ray, centre);
            const double inside = b * b - a * (glm::dot(centre, centre) - radius * radius);
            const double z = inside > 0 ? (b - std::sqrt(inside)) / a : 3;
            frame.depth()[static_cast<std::size_t>(i)] =
                i % 7 == 0 ? 0 : static_cast<std::uint16_t>(std::lround(z / form.depthUnitM));
        }
        return frame;
    }
    calib::SensorRig rig;
    FramePool pool{2};
};

// The band about the eyes of a ball of 100 mm is up to 18 mm behind its front, in the mean a third.
TEST_F(MeasuredDepth, IsTheFacesThroughTheRig) {
    for (const double z : {0.6, 1.0, 1.5}) {
        const glm::dvec3 front{0.1, -0.06, z};
        const glm::dvec3 centre = front + 0.1 * glm::normalize(front);
        const Frame depth = ball(centre, 0.1);
        // By the spacing it would have been 12 % farther.
        const auto found = measuredDepth(depth, rig, looking(1.12 * front, 0, 0.063));
        ASSERT_TRUE(found) << z;
        EXPECT_NEAR(*found, z, 0.018) << z;
    }
}

TEST_F(MeasuredDepth, IsNothingWithoutMeasurementsAboutThere) {
    const Frame depth = ball({0, 0, 1.1}, 0.1);
    EXPECT_FALSE(measuredDepth(depth, rig, looking({0.4, 0, 1}, 0, 0.063))) << "the wall behind";
    EXPECT_FALSE(measuredDepth(depth, rig, looking({0, 0, 0.6}, 0, 0.063))) << "far behind";
    EXPECT_FALSE(measuredDepth(depth, rig, looking({5, 0, 1}, 0, 0.063))) << "out of the picture";
    EXPECT_FALSE(measuredDepth(depth, rig, looking({0, 3, -1}, 0, 0.063))) << "behind the camera";
}

} // namespace
} // namespace autostereo::test
