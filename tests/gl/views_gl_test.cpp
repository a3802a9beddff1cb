// Methods agree, views lie in order, near things move against far ones, exports show the same.

#include "gpu/exports.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/gl_scene.hpp"
#include "tests/support/image_compare.hpp"

namespace autostereo::test {
namespace {

class ViewsGlTest : public GlTest {
  protected:
    gpu::RgbImage atlasBy(gpu::Method method) {
        params.synthesis.method = method;
        pipeline = std::make_unique<gpu::Pipeline>(params, pair.rig, display, display.width,
                                                   display.height);
        pipeline->prepare(pair.frame);
        const gpu::AtlasLayout& layout = pipeline->atlas()->layout();
        return gpu::readFramebuffer(pipeline->atlas()->framebuffer(), layout.width(),
                                    layout.height());
    }

    CapturedPair pair = simulate("sim:room?depth=176x144&color=640x360&noise=off");
    gpu::PipelineParams params;
    calib::DisplayProfile display = smallLensDisplay(3, 3, 96, 128);
    std::unique_ptr<gpu::Pipeline> pipeline;
};

double meanDifference(const gpu::RgbImage& a, const gpu::RgbImage& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        sum += std::abs(a.pixels[i] - b.pixels[i]);
    return sum / static_cast<double>(a.pixels.size());
}

double psnr(const gpu::RgbImage& a, const gpu::RgbImage& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        sum += std::pow(a.pixels[i] - b.pixels[i], 2);
    return 10 * std::log10(255 * 255 * static_cast<double>(a.pixels.size()) / sum);
}

/// The same triangles under two viewport transforms: positions round differently by 1/256 pixel,
/// which shows at silhouettes only.
TEST_F(ViewsGlTest, InstancedEqualsMultipass) {
    if (IsSkipped()) return;
    const gpu::RgbImage instanced = atlasBy(gpu::Method::Instanced);
    const gpu::RgbImage multipass = atlasBy(gpu::Method::Multipass);
    std::size_t different = 0;
    for (std::size_t i = 0; i < instanced.pixels.size(); ++i)
        if (std::abs(instanced.pixels[i] - multipass.pixels[i]) > 2) ++different;
    EXPECT_LE(different, instanced.pixels.size() / 2000);
}

/// The papers' own ways to the same pictures: the same vertices by another shader stage, so what
/// differs is rounding. Views split over passes are the same views.
TEST_F(ViewsGlTest, GeometryAndLayersEqualMultipass) {
    if (IsSkipped()) return;
    const gpu::RgbImage multipass = atlasBy(gpu::Method::Multipass);
    for (const gpu::Method method : {gpu::Method::Geometry, gpu::Method::Layered})
        for (const int viewsPerPass : {0, 4, 1}) {
            params.synthesis.viewsPerPass = viewsPerPass;
            const gpu::RgbImage other = atlasBy(method);
            std::size_t different = 0;
            for (std::size_t i = 0; i < other.pixels.size(); ++i)
                if (std::abs(other.pixels[i] - multipass.pixels[i]) > 2) ++different;
            EXPECT_LE(different, other.pixels.size() / 2000) << viewsPerPass << " views a pass";
        }
}

/// The super-multi-view paper's law: more references, fewer places that none of them sees.
TEST_F(ViewsGlTest, MoreReferencesAreCloserToEveryViewDrawn) {
    if (IsSkipped()) return;
    const gpu::RgbImage multipass = atlasBy(gpu::Method::Multipass);
    double last = 25; // dB
    for (const int references : {2, 3, 4}) {
        params.synthesis.references = references;
        const double now = psnr(atlasBy(gpu::Method::Hybrid), multipass);
        std::printf("%d references: %.2f dB\n", references, now);
        EXPECT_GT(now, last);
        last = now;
    }
}

/// A tile's own view at the panel's size, drawn as an eye sees it, scaled down by leaving out: the
/// eye pass and the tile pass are different formulas for one geometry.
TEST_F(ViewsGlTest, AnEyeOnTheFanSeesItsTile) {
    if (IsSkipped()) return;
    const gpu::RgbImage atlas = atlasBy(gpu::Method::Instanced);
    const double halfWidth = display.viewingDistanceM * std::tan(display.coneRad / 2);
    for (int view = 0; view < display.views; ++view) {
        const double b = (2.0 * view + 1) / display.views - 1;
        const gpu::RgbImage seen = gpu::renderEye(
            *pipeline, params, display, {b * halfWidth, 0, display.viewingDistanceM}, 96, 128);
        const gpu::RgbImage tile = gpu::crop(atlas, view % 3 * 96, (2 - view / 3) * 128, 96, 128);
        EXPECT_LT(meanDifference(seen, tile), 0.1) << "view " << view; // silhouettes only
    }
}

/// The camera's own place gives the camera's own picture, but for what depth noise, holes and the
/// piecewise-linear distortion between nodes do to it.
TEST_F(ViewsGlTest, TheUnmovedCameraSeesItsOwnPicture) {
    if (IsSkipped()) return;
    pair = simulate("sim:room?depth=640x576&color=320x180&noise=off");
    static_cast<void>(atlasBy(gpu::Method::Instanced));
    const gpu::RgbImage seen = gpu::MovedCamera(params, pair.rig, {0, 0, 0}).render(*pipeline);
    const oracle::Picture color = colorPicture(pair.frame.color);
    std::size_t close = 0, inside = 0;
    // The depth camera covers less than the colour camera: look at the middle.
    for (int y = 30; y < 150; ++y)
        for (int x = 60; x < 260; ++x, ++inside) {
            const auto at = 3 * (static_cast<std::size_t>(y) * 320 + static_cast<std::size_t>(x));
            double off = 0;
            for (std::size_t c = 0; c < 3; ++c)
                off = std::max(off, std::abs(seen.pixels[at + c] - color.at(x, y)[c]));
            if (off <= 3) ++close; // a hundredth of a pixel on a strong edge
        }
    EXPECT_GE(static_cast<double>(close), 0.97 * static_cast<double>(inside));
}

/// Registered depth against the scene itself, along the colour camera's rays.
TEST_F(ViewsGlTest, RegisteredDepthIsTheScenes) {
    if (IsSkipped()) return;
    pair = simulate("sim:room?depth=640x576&color=320x180&noise=off");
    static_cast<void>(atlasBy(gpu::Method::Instanced));
    const gpu::DepthImage depth =
        gpu::renderRegisteredDepth(pipeline->depth(), 0.001, params, pair.rig);
    ASSERT_EQ(depth.width, 320);
    ASSERT_EQ(depth.height, 180);
    const auto scene = devices::sim::makeScene("room", 1);
    std::vector<double> errors;
    for (int y = 20; y < 160; y += 3)
        for (int x = 40; x < 280; x += 3) {
            const int pixel = y * 320 + x;
            const auto measured = depth.millimetres[static_cast<std::size_t>(pixel)];
            if (measured == 0) continue;
            const auto ray = pair.rig.color.unproject({x, y});
            const auto hit = scene->trace({0, 0, 0}, glm::dvec3(*ray, 1), 0);
            errors.push_back(std::abs(measured * 1e-3 - hit.point.z));
        }
    ASSERT_GT(errors.size(), 3000U);
    std::sort(errors.begin(), errors.end());
    // Whole millimetres twice (sensor and picture), and flat triangles under curved things.
    EXPECT_LT(errors[errors.size() / 2], 0.001);
    EXPECT_LT(errors[errors.size() * 9 / 10], 0.004);
}

} // namespace
} // namespace autostereo::test
