// The direct method against double precision: the same layers, every sub-pixel searched by hand.

#include "config/load.hpp"
#include "tests/gl/scene_support.hpp"
#include "tests/gl/search_support.hpp"
#include "tests/oracle/searched_panel.hpp"
#include "tests/support/gl_fixture.hpp"

#include <cstdio>

namespace autostereo::test {
namespace {

struct Differences {
    double squares = 0, largest = 0;
    std::size_t samples = 0, overTwo = 0, unexplained = 0;

    [[nodiscard]] double psnr() const {
        return 10 * std::log10(255 * 255 / (squares / static_cast<double>(samples)));
    }
};

/// More than two levels off only where the oracle itself goes there within a thousandth of a
/// sub-pixel: a silhouette that float and double put on either side, or a surface seen along
/// itself.
bool isTie(const oracle::SearchInput& in, const oracle::SearchedPanel& panel, int x, int y, int c,
           double value) {
    constexpr double kShare = 1e-3 / 3;
    double least = 255, most = 0;
    for (const double right : {-kShare, 0.0, kShare})
        for (const double up : {-kShare, 0.0, kShare}) {
            const double beside = panel.level(in, x, y, c, right, up);
            least = std::min(least, beside);
            most = std::max(most, beside);
        }
    return value >= least - 2.5 && value <= most + 2.5;
}

Differences compare(const gpu::RgbImage& image, const oracle::SearchInput& in,
                    const oracle::SearchedPanel& panel, int rowStep) {
    Differences found;
    for (int y = rowStep / 2; y < image.height; y += rowStep)
        for (int x = 0; x < image.width; ++x)
            for (int c = 0; c < 3; ++c) {
                const double value = image.pixels[3 * (static_cast<std::size_t>(y) *
                                                           static_cast<std::size_t>(image.width) +
                                                       static_cast<std::size_t>(x)) +
                                                  static_cast<std::size_t>(c)];
                const double off = std::abs(value - panel.level(in, x, y, c));
                ++found.samples;
                found.squares += off * off;
                found.largest = std::max(found.largest, off);
                if (off <= 2.5) continue;
                ++found.overTwo;
                if (!isTie(in, panel, x, y, c, value)) ++found.unexplained;
            }
    return found;
}

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
    const SimulatedPair pair = simulate(GetParam().uri, 2);
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

    const oracle::SearchedPanel truth(display, display.width, display.height, GetParam().positions);
    const Differences found =
        compare(image, searchInput(pair.rig, pipeline, colorPicture(pair.frame.color)), truth, 1);
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
    const SimulatedPair pair = simulate("sim:person?depth=176x144&color=640x360&noise=off");
    gpu::PipelineParams params;
    gpu::Pipeline pipeline(params, pair.rig, display, display.width, display.height);
    const gpu::gl::Texture target(GL_RGBA8, display.width, display.height);
    const gpu::gl::Framebuffer panel = gpu::gl::makeFramebuffer(target);
    pipeline.render(pair.frame, panel.name());
    const gpu::RgbImage image = gpu::readFramebuffer(panel.name(), display.width, display.height);

    constexpr int kRowStep = 61; // no multiple of any pattern's rows
    const oracle::SearchedPanel truth(display, display.width, display.height,
                                      gpu::ViewPositions::Continuous);
    const Differences found = compare(
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
