#include "devices/sim/scene_view.hpp"
#include "devices/sim/simulation.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <tuple>
#include <vector>

namespace autostereo::devices::sim {
namespace {

const calib::SensorRig kRig = simulatedRig(80, 72, 160, 90);

class SceneViewOf : public ::testing::TestWithParam<std::tuple<const char*, bool>> {
  protected:
    std::unique_ptr<Scene> scene = makeScene(std::get<0>(GetParam()), 1);
    calib::CameraModel camera = std::get<1>(GetParam()) ? kRig.color : kRig.depth;
    calib::RigidTransform pose =
        std::get<1>(GetParam()) ? calib::RigidTransform{} : kRig.colorFromDepth;
};

// The short cuts (fixed part kept, screen boxes of what moves) change no bit of the picture.
TEST_P(SceneViewOf, EqualsTracingEveryPixel) {
    const auto width = static_cast<std::size_t>(camera.intrinsics.width);
    const auto height = static_cast<std::size_t>(camera.intrinsics.height);
    std::vector<Hit> background(width * height);
    const SceneView view(*scene, camera, pose,
                         [&](std::size_t pixel, const Hit& hit) { background[pixel] = hit; });
    for (const double time : {0.0, 0.9, 2.2, 3.7, 1000.4}) {
        std::vector<Hit> drawn = background;
        std::size_t moved = 0;
        view.drawMoving(time, [&](std::size_t pixel, const Hit& hit) {
            drawn[pixel] = hit;
            ++moved;
        });
        EXPECT_EQ(moved > 0, std::get<0>(GetParam()) != std::string("room"));
        const Snapshot now = scene->at(time);
        for (std::size_t pixel = 0; pixel < drawn.size(); ++pixel) {
            const auto truth = hitAtPixel(now, camera, pose, {pixel % width, pixel / width});
            ASSERT_TRUE(truth) << pixel;
            ASSERT_EQ(drawn[pixel].distance, truth->distance) << pixel << " at " << time;
            ASSERT_EQ(drawn[pixel].color, truth->color) << pixel << " at " << time;
            ASSERT_EQ(drawn[pixel].irReflectance, truth->irReflectance) << pixel;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, SceneViewOf,
    ::testing::Combine(::testing::Values("room", "person", "calibration-board"), ::testing::Bool()),
    [](const auto& instance) {
        std::string name = std::get<0>(instance.param);
        std::erase(name, '-');
        return name + (std::get<1>(instance.param) ? "Color" : "Depth");
    });

// What the depth camera measures, carried over by the rig, is what the colour camera sees there.
TEST(SimulatedRig, BothCamerasSeeTheSamePoint) {
    const auto scene = makeScene("person", 1);
    const Snapshot now = scene->at(1.3);
    int same = 0, hidden = 0;
    for (int y = 0; y < 72; y += 3) {
        for (int x = 0; x < 80; x += 3) {
            const auto hit = hitAtPixel(now, kRig.depth, kRig.colorFromDepth, {x, y});
            const auto ray = kRig.depth.unproject({x, y});
            ASSERT_TRUE(hit && ray);
            const glm::dvec3 inDepth = hit->distance * glm::dvec3(*ray, 1.0);
            const glm::dvec3 inColor = kRig.colorFromDepth * inDepth;
            EXPECT_LT(glm::distance(inColor, hit->point), 1e-12);
            const auto pixel = kRig.color.project(inColor);
            if (!pixel) continue; // beside the colour picture, where its lens model ends
            const auto seen = hitAtPixel(now, kRig.color, {}, *pixel);
            ASSERT_TRUE(seen);
            // Unprojecting is good to 1e-12 of the distance; steep surfaces stretch it.
            if (glm::distance(seen->point, inColor) < 1e-8) {
                ++same;
            } else {
                EXPECT_LT(seen->distance, inColor.z); // only something nearer may hide it
                ++hidden;
            }
        }
    }
    EXPECT_GT(same, 500);
    EXPECT_LT(hidden, same / 10);
}

TEST(SimulatedRig, HasTheNominalFields) {
    constexpr double kDegree = 3.14159265358979323846 / 180;
    for (const auto& [width, height] : {std::pair{176, 144},
                                        {320, 288},
                                        {512, 424},
                                        {640, 480},
                                        {640, 576},
                                        {1024, 1024},
                                        {16, 16}}) {
        const calib::SensorRig rig = simulatedRig(width, height, 1280, 720);
        EXPECT_FALSE(calib::problemWith(rig.depth));
        const double y = rig.depth.intrinsics.cy, x = rig.depth.intrinsics.cx;
        const auto left = rig.depth.unproject({-0.5, y}),
                   right = rig.depth.unproject({width - 0.5, y});
        const auto top = rig.depth.unproject({x, -0.5}),
                   bottom = rig.depth.unproject({x, height - 0.5});
        ASSERT_TRUE(left && right && top && bottom);
        const double across = (std::atan(right->x) - std::atan(left->x)) / kDegree;
        const double down = (std::atan(bottom->y) - std::atan(top->y)) / kDegree;
        // At most 75 x 65 degrees; 0.2 for the axis half a percent off the middle.
        EXPECT_LT(across, 75.2);
        EXPECT_LT(down, 65.2);
        EXPECT_TRUE(across > 74.8 || down > 64.8) << across << " x " << down;
        for (const glm::dvec2 corner :
             {glm::dvec2(0, 0), glm::dvec2(width - 1, 0), glm::dvec2(0, height - 1),
              glm::dvec2(width - 1, height - 1)}) {
            EXPECT_TRUE(rig.depth.unproject(corner)) << width << 'x' << height;
        }
    }
}

} // namespace
} // namespace autostereo::devices::sim
