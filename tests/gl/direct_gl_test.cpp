// The direct method against double precision: the same layers, every sub-pixel searched by hand.

#include "calib/optics.hpp"
#include "calib/panel_map.hpp"
#include "gpu/views/layer_search.hpp"
#include "tests/gl/scene_support.hpp"
#include "tests/oracle/first_hit_oracle.hpp"
#include "tests/support/gl_fixture.hpp"

#include <cstdio>

namespace autostereo::test {
namespace {

oracle::SearchInput searchInput(const SimulatedPair& pair, const gpu::Pipeline& pipeline) {
    gpu::LayerSearch search;
    search.build(pipeline.scene());
    const int columns = search.quads().width(), rows = search.quads().height() / 2;
    std::vector<glm::vec4> texels(static_cast<std::size_t>(columns) *
                                  static_cast<std::size_t>(2 * rows));
    glGetTextureImage(search.quads().name(), 0, GL_RGBA, GL_FLOAT,
                      static_cast<GLsizei>(texels.size() * sizeof(glm::vec4)), texels.data());
    const auto layer = [&](int first) {
        return oracle::Grid<oracle::Quad>::of(columns, rows, [&](int x, int y) {
            const glm::vec4& quad =
                texels[static_cast<std::size_t>(first + y) * static_cast<std::size_t>(columns) +
                       static_cast<std::size_t>(x)];
            return oracle::Quad{quad.x, quad.y, quad.z, quad.w};
        });
    };
    return {pair.rig,
            pipeline.geometry(),
            layer(0),
            layer(rows),
            colorPicture(pair.frame.color),
            readPicture(pipeline.fusion().background().color())};
}

/// Where a sub-pixel lies and which eye it is for, by the formulas of the header files.
struct Subpixel {
    double x, v, b;
};

struct Panel {
    calib::DisplayProfile display;
    calib::ViewMap map;
    gpu::ViewPositions positions;
    double channelStep;

    [[nodiscard]] Subpixel at(int x, int y, int c) const {
        const std::uint32_t phase = map.phase(x, y, c);
        const double cycles = phase / 4294967296.0;
        double b = calib::viewPosition(display, static_cast<int>(map.view(phase)));
        if (positions == gpu::ViewPositions::Continuous)
            b = map.reversed ? 1 - 2 * cycles : 2 * cycles - 1;
        return {(x + 0.5) / display.width + (c - 1) * channelStep, 1 - (y + 0.5) / display.height,
                b};
    }
};

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
bool isTie(const oracle::SearchInput& in, const Subpixel& at, const calib::DisplayProfile& display,
           double value, std::size_t channel) {
    constexpr double kShare = 1e-3 / 3;
    double least = 255, most = 0;
    for (const double right : {-kShare, 0.0, kShare})
        for (const double up : {-kShare, 0.0, kShare}) {
            const auto beside = oracle::searchedColor(in, at.b, at.x + right / display.width,
                                                      at.v + up / display.height);
            least = std::min(least, beside[channel]);
            most = std::max(most, beside[channel]);
        }
    return value >= least - 2.5 && value <= most + 2.5;
}

Differences compare(const gpu::RgbImage& image, const oracle::SearchInput& in, const Panel& panel) {
    Differences found;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (int c = 0; c < 3; ++c) {
                const auto channel = static_cast<std::size_t>(c);
                const double value = image.pixels[3 * (static_cast<std::size_t>(y) *
                                                           static_cast<std::size_t>(image.width) +
                                                       static_cast<std::size_t>(x)) +
                                                  channel];
                const Subpixel at = panel.at(x, y, c);
                const double off =
                    std::abs(value - oracle::searchedColor(in, at.b, at.x, at.v)[channel]);
                ++found.samples;
                found.squares += off * off;
                found.largest = std::max(found.largest, off);
                if (off <= 2.5) continue;
                ++found.overTwo;
                if (!isTie(in, at, panel.display, value, channel)) ++found.unexplained;
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

    const Panel formulas{display, calib::makeViewMap(display, display.width, display.height),
                         GetParam().positions, 1.0 / 3 / display.width};
    const Differences found = compare(image, searchInput(pair, pipeline), formulas);
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

} // namespace
} // namespace autostereo::test
