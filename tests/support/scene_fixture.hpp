#pragma once

#include "gpu/scene/scene_pipeline.hpp"
#include "tests/oracle/scene_oracle.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/gl_scene.hpp"
#include "tests/support/mesh_shapes.hpp"

#include <cmath>
#include <optional>
#include <vector>

namespace autostereo::test {

/// Two balls under three kinds of light on a small lens sheet of nine views, drawn by any method.
class SceneGlTest : public GlTest {
  protected:
    static constexpr double kSeconds = 1.3;

    void SetUp() override {
        GlTest::SetUp();
        look.share = 1.4; // two balls fill little of their box
        look.lights = {{.color = {0.5, 0.5, 0.45}, .direction = {0.4, -0.6, -0.9}},
                       {.kind = gpu::SceneLight::Kind::Point,
                        .color = {0.6, 0.3, 0.2},
                        .position = {0.3 * display.widthM, 0.1, 0.2},
                        .reachM = 0.4},
                       {.kind = gpu::SceneLight::Kind::Spot,
                        .color = {0.3, 0.9, 1.2},
                        .position = {-0.4 * display.widthM, 0.2, 0.4},
                        .direction = {0.4, -0.35, -1},
                        .coneRad = 0.7}};
    }
    gpu::ScenePipeline& draw(const gpu::SceneParams& with) {
        pipeline.emplace(scene, with, params, display, display.width, display.height);
        pipeline->prepare(kSeconds);
        return *pipeline;
    }
    gpu::RgbImage atlasBy(gpu::Method method, gpu::SceneShading shading) {
        params.synthesis.method = method;
        look.shading = shading;
        const gpu::Atlas& atlas = draw(look).atlas();
        return gpu::readFramebuffer(atlas.framebuffer(), atlas.layout().width(),
                                    atlas.layout().height());
    }
    gpu::RgbImage panelBy(gpu::Method method) {
        params.synthesis.method = method;
        const gpu::gl::Texture panel(GL_RGBA8, display.width, display.height);
        const gpu::gl::Framebuffer target = gpu::gl::makeFramebuffer(panel);
        draw(look).show(target.name());
        return gpu::readFramebuffer(target.name(), display.width, display.height);
    }
    /// A polished ball, lit from the front, with a highlight and nothing else.
    void showHighlight() {
        scene = emptyScene();
        scene.materials[0] = {
            .name = "ball", .diffuse = glm::vec3(0), .specular = glm::vec3(1), .shininess = 200};
        addBall(scene, {0, 0, 0}, 1, 40, 0);
        look.lights = {{.direction = {0, 0, -1}}};
        look.ambient = glm::dvec3(0);
        look.tiltRad = 0;
        look.share = 0.9;
    }
    /// Where on the panel an eye at b sees that highlight, metres from the middle. Light from the
    /// front: its mirror image lies where the normal points halfway to the eye, at half the eye's
    /// angle, so on the ball (radius r) about r sin(angle/2) aside, and nearer than the panel by r
    /// cos, at its share of height.
    [[nodiscard]] double mirroredAt(double b) const {
        const double r = pipeline->placement().radiusM;
        const double d = display.viewingDistanceM, e = b * d * std::tan(display.coneRad / 2);
        double half = std::atan2(e, d) / 2;
        for (int i = 0; i < 20; ++i) // to the eye from the highlight itself
            half = std::atan2(e - r * std::sin(half), d - r * std::cos(half)) / 2;
        const double x = r * std::sin(half);
        const double z = r * std::cos(half) * pipeline->placement().flattening;
        return (x * d - e * z) / (d - z);
    }
    /// The middle of a tile's light, metres from its middle.
    [[nodiscard]] double lightMiddle(const gpu::RgbImage& tile) const {
        double sum = 0, weighted = 0;
        for (std::size_t i = 0; i < tile.pixels.size(); i += 3) {
            const auto column = i / 3 % static_cast<std::size_t>(tile.width);
            sum += tile.pixels[i];
            weighted += tile.pixels[i] * (static_cast<double>(column) + 0.5);
        }
        return (weighted / sum / tile.width - 0.5) * display.widthM;
    }
    /// A view's tile of the atlas.
    [[nodiscard]] gpu::RgbImage tileOf(const gpu::RgbImage& atlas, int view) const {
        const int width = atlas.width / display.quilt.columns;
        const int height = atlas.height / display.quilt.rows;
        return gpu::crop(atlas, view % display.quilt.columns * width,
                         (display.quilt.rows - 1 - view / display.quilt.columns) * height, width,
                         height);
    }
    [[nodiscard]] std::vector<oracle::SceneTriangle> triangles() const {
        return oracle::trianglesOf(scene, kSeconds,
                                   pipeline->placement().transform(look, kSeconds));
    }

    devices::mesh::MeshScene scene = twoBalls();
    gpu::SceneParams look;
    gpu::PipelineParams params;
    calib::DisplayProfile display = smallLensDisplay(3, 3, 96, 128);
    std::optional<gpu::ScenePipeline> pipeline;
};

} // namespace autostereo::test
