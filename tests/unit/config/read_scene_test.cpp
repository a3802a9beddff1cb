// [scene]: every key arrives, what cannot be is refused with its place.

#include "config/load.hpp"
#include "tests/unit/config/temp_folder.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace autostereo::config {
namespace {

void expectSame(const gpu::SceneParams& a, const gpu::SceneParams& b) {
    EXPECT_EQ(a.up, b.up);
    EXPECT_DOUBLE_EQ(a.share, b.share);
    EXPECT_EQ(a.turnS, b.turnS);
    EXPECT_DOUBLE_EQ(a.startRad, b.startRad);
    EXPECT_DOUBLE_EQ(a.tiltRad, b.tiltRad);
    EXPECT_EQ(a.shading, b.shading);
    EXPECT_EQ(a.ambient, b.ambient);
    ASSERT_EQ(a.lights.size(), b.lights.size());
    for (std::size_t i = 0; i < a.lights.size(); ++i) {
        EXPECT_EQ(a.lights[i].kind, b.lights[i].kind);
        EXPECT_EQ(a.lights[i].color, b.lights[i].color);
        EXPECT_EQ(a.lights[i].position, b.lights[i].position);
        EXPECT_EQ(a.lights[i].direction, b.lights[i].direction);
        EXPECT_EQ(a.lights[i].reachM, b.lights[i].reachM);
        EXPECT_DOUBLE_EQ(a.lights[i].coneRad, b.lights[i].coneRad);
    }
}

class ReadScene : public test::TempFolder {};

TEST_F(ReadScene, defaultFileGivesTheDefaultsOfTheStruct) {
    expectSame(defaultConfig().scene, gpu::SceneParams{});
}

TEST_F(ReadScene, everyKeyArrives) {
    write("scene.toml", R"([scene]
up = "z"
share_percent = 150
turn_s = -3
start_deg = 90
tilt_deg = -45
shading = "per-vertex"
ambient = [0, 0.5, 1]
directional_lights = []
point_lights = [[1, 2, 3, 4, 5, 6, 7]]
spot_lights = [[1, 2, 3, 0, 0, -1, 4, 5, 6, 7, 90], [0, 0, 1, 0, 1, 0, 1, 1, 1, 2, 1]]
)");
    constexpr double kPi = std::numbers::pi;
    using Kind = gpu::SceneLight::Kind;
    gpu::SceneParams expected{.up = gpu::SceneUp::Z,
                              .share = 1.5,
                              .turnS = -3,
                              .startRad = kPi / 2,
                              .tiltRad = -kPi / 4,
                              .shading = gpu::SceneShading::PerVertex,
                              .ambient = {0, 0.5, 1}};
    expected.lights = {{Kind::Point, {4, 5, 6}, {1, 2, 3}, {0, 0, -1}, 7},
                       {Kind::Spot, {4, 5, 6}, {1, 2, 3}, {0, 0, -1}, 7, kPi / 2},
                       {Kind::Spot, {1, 1, 1}, {0, 0, 1}, {0, 1, 0}, 2, kPi / 180}};
    expectSame(loadConfig("scene.toml").scene, expected);
}

TEST_F(ReadScene, whatCannotShineIsRefused) {
    const auto says = [&](const std::string& line, const std::string& what) {
        write("bad.toml", "[scene]\n" + line + "\n");
        try {
            static_cast<void>(loadConfig("bad.toml"));
            FAIL() << line;
        } catch (const ConfigError& error) {
            EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
        }
    };
    says("shading = \"phong\"", "scene.shading");
    says("share_percent = 0", "scene.share_percent: 0 is out of range (allowed 1 to 400)");
    says("directional_lights = [[0, 0, 0, 1, 1, 1]]", "has a direction of length 0");
    says("directional_lights = [[0, 0, 1, 1, 1]]", "directional_lights");
    says("directional_lights = [[0, 0, 1, -1, 1, 1]]", "has a colour below 0");
    says("directional_lights = [[0, 0, inf, 1, 1, 1]]", "directional_lights");
    says("point_lights = [[0, 0, 1, 1, 1, 1, 0]]", "has a reach below 0.001");
    says("spot_lights = [[0, 0, 1, 0, 0, 1, 1, 1, 1, 1, 180]]", "has a cone that is not");
    std::string rows;
    for (int i = 0; i < 7; ++i)
        rows += "[0, 0, 1, 1, 1, 1, 1],";
    says("point_lights = [" + rows + "]", "more than eight lights");
}

} // namespace
} // namespace autostereo::config
