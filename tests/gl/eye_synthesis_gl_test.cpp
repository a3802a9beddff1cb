// Two eyes that walk by a tracked barrier: what each sees through it, judged by the optical
// simulator, against the exact picture for its place on every sub-pixel.

#include "calib/look.hpp"
#include "gpu/views/eye_synthesis.hpp"
#include "tests/oracle/eye_oracle.hpp"
#include "tests/support/barrier_part.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/gl_scene.hpp"
#include "tests/support/walker.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace autostereo::test {
namespace {

constexpr int kPartWidth = 320, kPartHeight = 200; // pixels
/// Rows in the middle of the panel, a panel of their own in the same place: lines go on by one
/// period in 33 rows, so that all places of a slit before a pixel are among them.
constexpr int kStripRows = 48;

/// Of a layer, what the strip may show: triangles up to two strips above and below, which is
/// farther than an eye's height moves anything.
oracle::Layer stripLayer(oracle::Layer layer) {
    for (auto& node : layer.nodes)
        if (node) node->v = (node->v - 0.5) * kPartHeight / kStripRows + 0.5;
    std::erase_if(layer.triangles, [&](const std::array<int, 3>& triangle) {
        return std::ranges::all_of(triangle, [&](int corner) {
            return std::abs(layer.nodes[static_cast<std::size_t>(corner)]->v - 0.5) > 2.5;
        });
    });
    return layer;
}

std::vector<std::uint8_t> bytesOf(const oracle::Picture& picture) {
    std::vector<std::uint8_t> bytes;
    for (const auto& pixel : picture.pixels)
        for (const double level : pixel)
            bytes.push_back(static_cast<std::uint8_t>(std::lround(level)));
    return bytes;
}

double psnr(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    double squares = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        squares += (static_cast<double>(a[i]) - b[i]) * (static_cast<double>(a[i]) - b[i]);
    return 10 * std::log10(255.0 * 255 * static_cast<double>(a.size()) / std::max(squares, 1e-9));
}

class EyeSynthesisGlTest : public GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        gpu::PipelineParams params;
        params.synthesis.followEyes = true;
        pipeline.emplace(params, pair.rig, display, display.width, display.height);
        target = gpu::gl::Texture(GL_RGBA8, display.width, display.height);
        panel = gpu::gl::makeFramebuffer(target);
        pipeline->prepare(pair.frame);
        gpu::LayerMesher mesher;
        const gpu::MeshLayers& layers = mesher.build(pipeline->scene());
        scene = stripLayer(readLayer(layers.scene));
        background = stripLayer(readLayer(layers.background));
        backgroundColor = readPicture(*layers.backgroundColor);
        color = colorPicture(pair.frame.color);
    }
    void TearDown() override {
        pipeline.reset();
        panel = {};
        target = {};
        GlTest::TearDown();
    }

    [[nodiscard]] gpu::RgbImage shownTo(const calib::EyePair& eyes) {
        pipeline->setEyes(eyes);
        pipeline->show(panel.name());
        return gpu::readFramebuffer(panel.name(), kPartWidth, kPartHeight);
    }
    [[nodiscard]] static std::vector<std::uint8_t> stripOf(const gpu::RgbImage& shown) {
        return gpu::crop(shown, 0, (kPartHeight - kStripRows) / 2, kPartWidth, kStripRows).pixels;
    }
    [[nodiscard]] std::vector<std::uint8_t> exactFor(const glm::dvec3& eye) const {
        return bytesOf(oracle::eyePicture(scene, background, color, backgroundColor, strip, eye,
                                          kPartWidth, kStripRows));
    }
    [[nodiscard]] std::vector<std::uint8_t> seen(const std::vector<std::uint8_t>& shown,
                                                 const glm::dvec3& eye) const {
        return calib::look(optics, {optics.lenses.aperture, 0}, eye, shown).rgb;
    }

    CapturedPair pair = simulate("sim:room?depth=88x72&color=320x180&noise=off");
    calib::DisplayProfile display = barrierPart(kPartWidth, kPartHeight);
    calib::DisplayProfile strip = barrierPart(kPartWidth, kStripRows);
    calib::DisplayOptics optics = calib::displayOptics(strip).value();
    std::optional<gpu::Pipeline> pipeline;
    gpu::gl::Texture target;
    gpu::gl::Framebuffer panel;
    oracle::Layer scene, background;
    oracle::Picture color, backgroundColor;
};

TEST_F(EyeSynthesisGlTest, EachEyeOfAWalkerSeesItsOwnPicture) {
    if (IsSkipped()) return;
    const Walker walker(0.5, display.viewingDistanceM);
    constexpr int kPositions = 300;
    double least = 1e9, leastOther = 1e9, mean = 0;
    for (int i = 0; i < kPositions; ++i) {
        const calib::EyePair eyes = walker.at(0.1 + 7.0 * i / kPositions);
        const auto shown = stripOf(shownTo(eyes));
        const auto left = exactFor(eyes.left), right = exactFor(eyes.right);
        for (const bool isLeft : {true, false}) {
            const glm::dvec3& eye = isLeft ? eyes.left : eyes.right;
            const auto found = seen(shown, eye);
            const double own = psnr(found, seen(isLeft ? left : right, eye));
            least = std::min(least, own);
            mean += own / (2 * kPositions);
            leastOther = std::min(leastOther, psnr(found, seen(isLeft ? right : left, eye)));
        }
    }
    std::printf("%d positions: %.1f dB at least, %.1f dB on average; the other eye's picture would "
                "be %.1f dB\n",
                kPositions, least, mean, leastOther);
    EXPECT_GE(least, 38);      // 36 with one eye's place 10 % off; silhouettes cost what is left
    EXPECT_LT(leastOther, 30); // two pictures indeed
}

TEST_F(EyeSynthesisGlTest, WithoutAnEyeToFollowItIsTheNominalPair) {
    if (IsSkipped()) return;
    pipeline->show(panel.name());
    const auto shown = gpu::readFramebuffer(panel.name(), display.width, display.height).pixels;
    const double reach = display.viewingDistanceM * std::tan(display.coneRad / 2);
    const double distance = display.viewingDistanceM;
    EXPECT_EQ(shown, shownTo({{-reach, 0, distance}, {reach, 0, distance}}).pixels);
}

TEST_F(EyeSynthesisGlTest, WhatReachesAnEyeBreaksNothing) {
    if (IsSkipped()) return;
    for (const glm::dvec3& place :
         {glm::dvec3{0, 0, 0.1}, {0.05, 0.02, 0.101}, {9, 9, 0.1}, {-9, 9, 9}, {0, 0, 10}}) {
        const glm::dvec3 half{0.03, 0, 0};
        const gpu::RgbImage shown = shownTo({place - half, place + half});
        EXPECT_EQ(shown.pixels.size(), 3U * kPartWidth * kPartHeight);
    }
}

} // namespace
} // namespace autostereo::test
