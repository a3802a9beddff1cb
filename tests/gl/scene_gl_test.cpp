// Scenes of triangles in the views: against rays in double precision, method against method.

#include "gpu/scene/scene_pipeline.hpp"
#include "tests/oracle/scene_oracle.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/gl_scene.hpp"
#include "tests/support/mesh_shapes.hpp"

#include <cmath>

namespace autostereo::test {
namespace {

using gpu::SceneLight;
using gpu::SceneShading;

constexpr double kSeconds = 1.3;

class SceneGlTest : public GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        look.share = 1.4; // two balls fill little of their box
        look.lights = {{.color = {0.5, 0.5, 0.45}, .direction = {0.4, -0.6, -0.9}},
                       {.kind = SceneLight::Kind::Point,
                        .color = {0.6, 0.3, 0.2},
                        .position = {0.3 * display.widthM, 0.1, 0.2},
                        .reachM = 0.4},
                       {.kind = SceneLight::Kind::Spot,
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
    gpu::RgbImage atlasBy(gpu::Method method, SceneShading shading) {
        params.synthesis.method = method;
        look.shading = shading;
        const gpu::Atlas& atlas = draw(look).atlas();
        return gpu::readFramebuffer(atlas.framebuffer(), atlas.layout().width(),
                                    atlas.layout().height());
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

/// Levels by which a picture is off the rays' colours, where the rays beside a pixel's middle see
/// the same as the middle: the driver moves corners by up to half of 1/256 pixel.
struct Judgement {
    int compared = 0;
    int left = 0; ///< silhouettes, terminators
    int surface = 0;
    double worst = 0;
};

class Judge {
  public:
    Judge(const devices::mesh::MeshScene& scene, std::vector<oracle::SceneTriangle> triangles,
          const gpu::SceneParams& look, const calib::DisplayProfile& display, double flattening)
        : scene_(scene), triangles_(std::move(triangles)), look_(look), display_(display),
          flattening_(flattening) {}

    void compare(const gpu::RgbImage& seen, const glm::dvec3& eye, Judgement& judgement) const {
        constexpr int kStep = 3;
        constexpr double kBeside = 1.0 / 128; // pixels
        for (int y = 0; y < seen.height; y += kStep)
            for (int x = 0; x < seen.width; x += kStep) {
                const auto middle = color(seen, eye, x + 0.5, y + 0.5);
                double spread = 0;
                for (const auto& [dx, dy] : {std::pair{-1, -1}, {1, -1}, {-1, 1}, {1, 1}})
                    spread =
                        std::max(spread, distance(middle, color(seen, eye, x + 0.5 + dx * kBeside,
                                                                y + 0.5 + dy * kBeside)));
                if (spread > 1) {
                    ++judgement.left;
                    continue;
                }
                const auto at = 3 * static_cast<std::size_t>(y * seen.width + x);
                const glm::dvec3 drawn(seen.pixels[at], seen.pixels[at + 1], seen.pixels[at + 2]);
                ++judgement.compared;
                if (glm::length(middle) > 0) ++judgement.surface;
                judgement.worst = std::max(judgement.worst, distance(middle, drawn));
            }
    }

  private:
    static double distance(const glm::dvec3& a, const glm::dvec3& b) {
        const glm::dvec3 off = glm::abs(a - b);
        return std::max({off.r, off.g, off.b});
    }
    [[nodiscard]] glm::dvec3 color(const gpu::RgbImage& seen, const glm::dvec3& eye, double x,
                                   double y) const {
        const double width = display_.widthM, height = display_.heightM();
        const auto hit = oracle::firstHit(triangles_, eye, (x / seen.width - 0.5) * width,
                                          (0.5 - y / seen.height) * height, flattening_);
        return hit ? oracle::colorOf(*hit, scene_, look_, eye) : glm::dvec3(0);
    }

    const devices::mesh::MeshScene& scene_;
    std::vector<oracle::SceneTriangle> triangles_;
    const gpu::SceneParams& look_;
    const calib::DisplayProfile& display_;
    double flattening_;
};

/// Rounding to a level is half a level, and so much again may come from textures, whose texels the
/// driver mixes in steps of 1/256.
TEST_F(SceneGlTest, EveryViewIsWhatRaysSee) {
    if (IsSkipped()) return;
    for (const auto& [shading, most] : {std::pair{SceneShading::PerPixel, 1.0},
                                        {SceneShading::Textured, 1.0},
                                        {SceneShading::None, 0.51}}) {
        const gpu::RgbImage atlas = atlasBy(gpu::Method::Multipass, shading);
        const Judge judge(scene, triangles(), look, display, pipeline->placement().flattening);
        const double reach = display.viewingDistanceM * std::tan(display.coneRad / 2);
        Judgement judgement;
        for (const int view : {0, 4, 8}) {
            const double b = (2.0 * view + 1) / display.views - 1;
            judge.compare(gpu::crop(atlas, view % 3 * 96, (2 - view / 3) * 128, 96, 128),
                          {b * reach, 0, display.viewingDistanceM}, judgement);
        }
        std::printf("%d pixels, %d of them surface, worst %.2f levels, %d at edges left out\n",
                    judgement.compared, judgement.surface, judgement.worst, judgement.left);
        EXPECT_LE(judgement.worst, most);
        EXPECT_GT(judgement.surface, 600);
        EXPECT_LT(judgement.left, judgement.compared / 10);
    }
}

/// An eye nearer, higher and aside: the same formula with another eye.
TEST_F(SceneGlTest, AnyEyeSeesWhatRaysSee) {
    if (IsSkipped()) return;
    const glm::dvec3 eye{0.07, 0.15, 0.8 * display.viewingDistanceM};
    const gpu::RgbImage seen = draw(look).renderEye(eye, 96, 128);
    const Judge judge(scene, triangles(), look, display, pipeline->placement().flattening);
    Judgement judgement;
    judge.compare(seen, eye, judgement);
    EXPECT_LE(judgement.worst, 1.0);
    EXPECT_GT(judgement.surface, 200);
}

/// Other viewports and other shader stages: what differs is rounding, at silhouettes and where a
/// highlight or a terminator crosses a pixel's middle.
TEST_F(SceneGlTest, AllMethodsDrawWhatMultipassDraws) {
    if (IsSkipped()) return;
    for (const auto& [name, shading] : gpu::kSceneShadings) {
        const gpu::RgbImage multipass = atlasBy(gpu::Method::Multipass, shading);
        for (const gpu::Method method :
             {gpu::Method::Instanced, gpu::Method::Geometry, gpu::Method::Layered})
            for (const int viewsPerPass : {0, 4, 1}) {
                if (method == gpu::Method::Instanced && viewsPerPass > 0) continue;
                params.synthesis.viewsPerPass = viewsPerPass;
                const gpu::RgbImage other = atlasBy(method, shading);
                std::size_t different = 0;
                for (std::size_t i = 0; i < other.pixels.size(); ++i)
                    if (std::abs(other.pixels[i] - multipass.pixels[i]) > 1) ++different;
                EXPECT_LE(different, other.pixels.size() / 2000)
                    << gpu::methodName(method) << ", " << name << ", " << viewsPerPass;
            }
    }
}

/// Light at the corners is exact there; between them it is only as close as triangles are small.
TEST_F(SceneGlTest, LightAtVerticesComesCloserWithMoreOfThem) {
    if (IsSkipped()) return;
    double last = 255;
    for (const int rows : {6, 12, 48}) {
        scene = emptyScene();
        scene.materials[0] = {.name = "ball",
                              .diffuse = glm::vec3(0.5F),
                              .specular = glm::vec3(0.5F),
                              .shininess = 30};
        addBall(scene, {0, 0, 0}, 1, rows, 0);
        const gpu::RgbImage exact = atlasBy(gpu::Method::Instanced, SceneShading::PerPixel);
        const gpu::RgbImage seen = atlasBy(gpu::Method::Instanced, SceneShading::PerVertex);
        double sum = 0;
        for (std::size_t i = 0; i < seen.pixels.size(); ++i)
            sum += std::abs(seen.pixels[i] - exact.pixels[i]);
        const double mean = sum / static_cast<double>(seen.pixels.size());
        std::printf("%d rows: %.3f levels\n", rows, mean);
        EXPECT_LT(mean, last / 2);
        last = mean;
    }
}

/// Highlights belong to the eye: on a polished ball they are not where a surface's point moves.
TEST_F(SceneGlTest, HighlightsMoveWithTheEye) {
    if (IsSkipped()) return;
    scene = emptyScene();
    scene.materials[0] = {
        .name = "ball", .diffuse = glm::vec3(0), .specular = glm::vec3(1), .shininess = 200};
    addBall(scene, {0, 0, 0}, 1, 40, 0);
    look.lights = {{.direction = {0, 0, -1}}};
    look.ambient = glm::dvec3(0);
    look.tiltRad = 0;
    look.share = 0.9;
    params.synthesis.tileScale = 2;
    const gpu::RgbImage atlas = atlasBy(gpu::Method::Instanced, SceneShading::PerPixel);
    const auto highlight = [&](int view) {
        const gpu::RgbImage tile = gpu::crop(atlas, view % 3 * 192, (2 - view / 3) * 256, 192, 256);
        double sum = 0, weighted = 0;
        for (std::size_t i = 0; i < tile.pixels.size(); i += 3) {
            sum += tile.pixels[i];
            weighted += tile.pixels[i] * (static_cast<double>(i / 3 % 192) + 0.5);
        }
        return (weighted / sum / 192 - 0.5) * display.widthM;
    };
    // Light from the front: its mirror image lies where the normal points halfway to the eye, at
    // half the eye's angle, so on the ball (radius r) about r sin(angle/2) aside, and nearer than
    // the panel by r cos, at its share of height.
    const double r = pipeline->placement().radiusM;
    for (const int view : {0, 8}) {
        const double b = (2.0 * view + 1) / 9 - 1;
        const double d = display.viewingDistanceM, e = b * d * std::tan(display.coneRad / 2);
        double half = std::atan2(e, d) / 2;
        for (int i = 0; i < 20; ++i) // to the eye from the highlight itself
            half = std::atan2(e - r * std::sin(half), d - r * std::cos(half)) / 2;
        const double x = r * std::sin(half);
        const double z = r * std::cos(half) * pipeline->placement().flattening;
        EXPECT_NEAR(highlight(view), (x * d - e * z) / (d - z), 0.5 * display.widthM / 192)
            << "half a texel";
    }
}

/// The colour that stands behind the scene, on the panel too; and its views come to its sub-pixels.
TEST_F(SceneGlTest, ThePanelShowsTheSceneBeforeItsBackground) {
    if (IsSkipped()) return;
    params.clearColor = {0, 0, 1};
    gpu::ScenePipeline& shown = draw(look);
    const gpu::gl::Texture panel(GL_RGBA8, display.width, display.height);
    const gpu::gl::Framebuffer target = gpu::gl::makeFramebuffer(panel);
    shown.show(target.name());
    const gpu::RgbImage seen = gpu::readFramebuffer(target.name(), display.width, display.height);
    EXPECT_EQ(seen.pixels[0], 0);
    EXPECT_EQ(seen.pixels[2], 255);
    const auto middle =
        3 * static_cast<std::size_t>(display.height / 2 * display.width + display.width / 2);
    EXPECT_GT(seen.pixels[middle] + seen.pixels[middle + 1], 20);
}

} // namespace
} // namespace autostereo::test
