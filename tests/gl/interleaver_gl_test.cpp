// Which view a sub-pixel shows, decided on the GPU, equals the host's decision in every sub-pixel.

#include "config/load.hpp"
#include "gpu/interleaver.hpp"
#include "gpu/readback.hpp"
#include "tests/oracle/panel_oracle.hpp"
#include "tests/support/gl_fixture.hpp"

namespace autostereo::test {
namespace {

/// Every texel of view i's tile holds the level 4 i + 3.
gpu::Atlas numberedAtlas(const gpu::AtlasLayout& layout) {
    gpu::Atlas atlas(layout);
    std::vector<std::uint8_t> texels;
    for (int y = 0; y < layout.height(); ++y)
        for (int x = 0; x < layout.width(); ++x) {
            const int view =
                y / layout.quilt.tileHeight * layout.quilt.columns + x / layout.quilt.tileWidth;
            texels.insert(texels.end(), 4, static_cast<std::uint8_t>(4 * view + 3));
        }
    glTextureSubImage2D(atlas.color().name(), 0, 0, 0, layout.width(), layout.height(), GL_RGBA,
                        GL_UNSIGNED_BYTE, texels.data());
    return atlas;
}

struct Case {
    std::string display;
    gpu::TileFilter filter;
};

void PrintTo(const Case& tested, std::ostream* out) { // NOLINT(readability-identifier-naming)
    *out << tested.display << (tested.filter == gpu::TileFilter::Nearest ? " nearest" : " linear");
}

class InterleaverGlTest : public GlTest, public testing::WithParamInterface<Case> {};

TEST_P(InterleaverGlTest, EverySubpixelShowsTheHostsView) {
    calib::DisplayProfile display = config::loadDisplay(GetParam().display);
    if (display.width == 0) display.width = 640, display.height = 360;
    // Tiles of a few texels: neighbours must not leak in with either filter.
    gpu::AtlasLayout layout{display.views, display.quilt};
    layout.quilt.tileWidth = 7;
    layout.quilt.tileHeight = 5;
    const gpu::Atlas atlas = numberedAtlas(layout);
    const calib::ViewMap map = calib::makeViewMap(display, display.width, display.height);
    const gpu::gl::Texture target(GL_RGBA8, display.width, display.height);
    const gpu::gl::Framebuffer panel = gpu::gl::makeFramebuffer(target);
    gpu::Interleaver(map, GetParam().filter).render(atlas, panel.name());

    const gpu::RgbImage image = gpu::readFramebuffer(panel.name(), display.width, display.height);
    std::size_t at = 0, wrong = 0, wrongOracle = 0;
    for (int y = 0; y < display.height; ++y)
        for (int x = 0; x < display.width; ++x)
            for (int c = 0; c < 3; ++c, ++at) {
                const int shown = (image.pixels[at] - 3) / 4;
                if (shown != static_cast<int>(map.view(map.phase(x, y, c)))) ++wrong;
                if (shown != oracle::viewOf(display, x, y, c)) ++wrongOracle;
            }
    EXPECT_EQ(wrong, 0U);
    // 32 bits of phase against 64: a sub-pixel may lie within 2^-32 of a boundary, no more.
    EXPECT_LE(wrongOracle, at / 1'000'000);
}

std::vector<Case> allCases() {
    std::vector<Case> cases;
    for (const std::string& name : config::displayNames())
        for (const auto filter : {gpu::TileFilter::Nearest, gpu::TileFilter::Linear})
            cases.push_back({name, filter});
    return cases;
}

INSTANTIATE_TEST_SUITE_P(Displays, InterleaverGlTest, testing::ValuesIn(allCases()));

} // namespace
} // namespace autostereo::test
