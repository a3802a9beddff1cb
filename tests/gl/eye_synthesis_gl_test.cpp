// Two eyes that walk by a tracked barrier: what each sees through it, judged by the optical
// simulator, against the exact picture for its place on every sub-pixel.

#include "calib/look.hpp"
#include "config/load.hpp"
#include "gpu/views/eye_synthesis.hpp"
#include "tests/oracle/eye_oracle.hpp"
#include "tests/stress/campaign.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/gl_scene.hpp"
#include "tests/support/walker.hpp"

#include <cstdio>

namespace autostereo::test {
namespace {

/// A part of a real panel behind its real barrier, small enough to draw often.
calib::DisplayProfile partOfABarrier() {
    calib::DisplayProfile display = config::loadDisplay("personal-varrier-30-b");
    constexpr int kWidth = 640, kHeight = 400;
    display.widthM *= static_cast<double>(kWidth) / display.width;
    display.width = kWidth;
    display.height = kHeight;
    display.quilt = {2, 1, kWidth, kHeight};
    return display;
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
        scene = readLayer(layers.scene);
        background = readLayer(layers.background);
        backgroundColor = readPicture(*layers.backgroundColor);
        color = colorPicture(pair.frame.color);
    }
    void TearDown() override {
        pipeline.reset();
        panel = {};
        target = {};
        GlTest::TearDown();
    }

    [[nodiscard]] std::vector<std::uint8_t> shownTo(const calib::EyePair& eyes) {
        pipeline->setEyes(eyes);
        pipeline->show(panel.name());
        return gpu::readFramebuffer(panel.name(), display.width, display.height).pixels;
    }
    [[nodiscard]] std::vector<std::uint8_t> exactFor(const glm::dvec3& eye) const {
        return bytesOf(oracle::eyePicture(scene, background, color, backgroundColor, display, eye,
                                          display.width, display.height));
    }
    [[nodiscard]] std::vector<std::uint8_t> seen(const std::vector<std::uint8_t>& shown,
                                                 const glm::dvec3& eye) const {
        return calib::look(optics, {optics.lenses.aperture, 0}, eye, shown).rgb;
    }

    CapturedPair pair = simulate("sim:room?depth=176x144&color=640x360&noise=off");
    calib::DisplayProfile display = partOfABarrier();
    calib::DisplayOptics optics = calib::displayOptics(display).value();
    std::optional<gpu::Pipeline> pipeline;
    gpu::gl::Texture target;
    gpu::gl::Framebuffer panel;
    oracle::Layer scene, background;
    oracle::Picture color, backgroundColor;
};

TEST_F(EyeSynthesisGlTest, EachEyeOfAWalkerSeesItsOwnPicture) {
    if (IsSkipped()) return;
    const Walker walker(0.5, display.viewingDistanceM);
    const auto positions = static_cast<int>(campaign(8, 300));
    double least = 1e9, leastOther = 1e9, mean = 0;
    for (int i = 0; i < positions; ++i) {
        const calib::EyePair eyes = walker.at(0.1 + 7.0 * i / positions);
        const auto shown = shownTo(eyes);
        const auto left = exactFor(eyes.left), right = exactFor(eyes.right);
        for (const bool isLeft : {true, false}) {
            const glm::dvec3& eye = isLeft ? eyes.left : eyes.right;
            const auto found = seen(shown, eye);
            const double own = psnr(found, seen(isLeft ? left : right, eye));
            least = std::min(least, own);
            mean += own / (2 * positions);
            leastOther = std::min(leastOther, psnr(found, seen(isLeft ? right : left, eye)));
        }
    }
    std::printf("%d positions: %.1f dB at least, %.1f dB on average; the other eye's picture would "
                "be %.1f dB\n",
                positions, least, mean, leastOther);
    EXPECT_GE(least, 35);
    EXPECT_LT(leastOther, 30); // two pictures indeed
}

TEST_F(EyeSynthesisGlTest, WithoutAnEyeToFollowItIsTheNominalPair) {
    if (IsSkipped()) return;
    pipeline->show(panel.name());
    const auto shown = gpu::readFramebuffer(panel.name(), display.width, display.height).pixels;
    const double reach = display.viewingDistanceM * std::tan(display.coneRad / 2);
    const double distance = display.viewingDistanceM;
    EXPECT_EQ(shown, shownTo({{-reach, 0, distance}, {reach, 0, distance}}));
}

TEST_F(EyeSynthesisGlTest, WhatReachesAnEyeBreaksNothing) {
    if (IsSkipped()) return;
    for (const glm::dvec3& place :
         {glm::dvec3{0, 0, 0.1}, {0.05, 0.02, 0.101}, {9, 9, 0.1}, {-9, 9, 9}, {0, 0, 10}}) {
        const glm::dvec3 half{0.03, 0, 0};
        const auto shown = shownTo({place - half, place + half});
        EXPECT_EQ(shown.size(), 3U * 640 * 400);
    }
}

} // namespace
} // namespace autostereo::test
