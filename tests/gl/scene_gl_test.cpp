// Scenes of triangles in the views: against rays in double precision, method against method.

#include "tests/support/scene_fixture.hpp"

#include <cmath>

namespace autostereo::test {
namespace {

using gpu::SceneShading;

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
            judge.compare(tileOf(atlas, view), {b * reach, 0, display.viewingDistanceM}, judgement);
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
    showHighlight();
    params.synthesis.tileScale = 2;
    const gpu::RgbImage atlas = atlasBy(gpu::Method::Instanced, SceneShading::PerPixel);
    for (const int view : {0, 8})
        EXPECT_NEAR(lightMiddle(tileOf(atlas, view)), mirroredAt((2.0 * view + 1) / 9 - 1),
                    0.5 * display.widthM / 192)
            << "half a texel";
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
