// The direct method against double precision: the same layers, every sub-pixel searched by hand.

#include "config/load.hpp"
#include "tests/oracle/panel_differences.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/gl_scene.hpp"
#include "tests/support/gl_search_input.hpp"

#include <cstdio>

namespace autostereo::test {
namespace {

constexpr double kStripePx = 1.0 / 3; // red, green and blue side by side in a pixel

struct Case {
    const char* name;
    const char* uri;
    int views;
    gpu::ViewPositions positions;
};

void PrintTo(const Case& tested, std::ostream* out) { // NOLINT(readability-identifier-naming)
    *out << tested.uri << ", " << tested.views << " views";
}

class DirectGlTest : public GlTest, public testing::WithParamInterface<Case> {};

TEST_P(DirectGlTest, PanelAgreesWithTheOracle) {
    if (IsSkipped()) return;
    const CapturedPair pair = simulate(GetParam().uri, 2);
    calib::DisplayProfile display = smallLensDisplay(GetParam().views, 1, 64, 64);
    display.width = 192;
    display.height = 256;
    display.optics.kind = calib::Optics::Kind::Lens;
    gpu::PipelineParams params;
    params.synthesis.method = gpu::Method::Direct;
    params.synthesis.positions = GetParam().positions;
    gpu::Pipeline pipeline(params, pair.rig, display, display.width, display.height);
    const gpu::gl::Texture target(GL_RGBA8, display.width, display.height);
    const gpu::gl::Framebuffer panel = gpu::gl::makeFramebuffer(target);
    pipeline.render(pair.frame, panel.name());
    const gpu::RgbImage image = gpu::readFramebuffer(panel.name(), display.width, display.height);

    const oracle::SearchedPanel truth(display, display.width, display.height, GetParam().positions,
                                      kStripePx);
    const oracle::Differences found = oracle::compare(
        image, searchInput(pair.rig, pipeline, colorPicture(pair.frame.color)), truth, 1);
    std::printf("%s: %.2f dB, max %.0f, more than 2/255: %zu of %zu\n", GetParam().name,
                found.psnr(), found.largest, found.overTwo, found.samples);
    // Rounding to 8 bits and the filter's 8-bit weights leave 56 dB.
    EXPECT_GE(found.psnr(), 55.5);
    EXPECT_EQ(found.unexplained, 0U);
    EXPECT_LE(static_cast<double>(found.overTwo), 1e-4 * static_cast<double>(found.samples));
}

INSTANTIATE_TEST_SUITE_P(
    Each, DirectGlTest,
    testing::Values(
        Case{"FortyEight", "sim:room?depth=176x144&color=640x360", 48, gpu::ViewPositions::OfViews},
        Case{"Continuous", "sim:person?depth=320x288&color=640x360", 48,
             gpu::ViewPositions::Continuous},
        Case{"Two", "sim:person?depth=176x144&color=640x360", 2, gpu::ViewPositions::OfViews},
        Case{"One", "sim:room?depth=176x144&color=640x360", 1, gpu::ViewPositions::OfViews},
        Case{"Thousand", "sim:room?depth=176x144&color=640x360", 1000,
             gpu::ViewPositions::OfViews}),
    [](const auto& tested) { return tested.param.name; });

/// Every way of filling a panel that goes by phase or by bands, at the display's own size.
class DirectOnDisplaysGlTest : public GlTest, public testing::WithParamInterface<const char*> {};

TEST_P(DirectOnDisplaysGlTest, PanelAgreesWithTheOracle) {
    if (IsSkipped()) return;
    const calib::DisplayProfile display = config::loadDisplay(GetParam());
    const CapturedPair pair = simulate("sim:person?depth=176x144&color=640x360&noise=off");
    gpu::PipelineParams params;
    gpu::Pipeline pipeline(params, pair.rig, display, display.width, display.height);
    const gpu::gl::Texture target(GL_RGBA8, display.width, display.height);
    const gpu::gl::Framebuffer panel = gpu::gl::makeFramebuffer(target);
    pipeline.render(pair.frame, panel.name());
    const gpu::RgbImage image = gpu::readFramebuffer(panel.name(), display.width, display.height);

    constexpr int kRowStep = 61; // no multiple of any pattern's rows
    const oracle::SearchedPanel truth(display, display.width, display.height,
                                      gpu::ViewPositions::Continuous, kStripePx);
    const oracle::Differences found = oracle::compare(
        image, searchInput(pair.rig, pipeline, colorPicture(pair.frame.color)), truth, kRowStep);
    std::printf("%s: %.2f dB, max %.0f, more than 2/255: %zu of %zu\n", GetParam(), found.psnr(),
                found.largest, found.overTwo, found.samples);
    EXPECT_GE(found.psnr(), 55.5);
    EXPECT_EQ(found.unexplained, 0U);
}

INSTANTIATE_TEST_SUITE_P(Shipped, DirectOnDisplaysGlTest,
                         testing::Values("slanted-8view-1080p", "barrier-5view", "barrier-8view",
                                         "cubevi-c1", "desorbier-2008-slanted", "looking-glass-go",
                                         "looking-glass-portrait", "personal-varrier-30",
                                         "tracked-lens-15.6"));

} // namespace
} // namespace autostereo::test
