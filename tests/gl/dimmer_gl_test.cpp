// Brightness: every level times a number, nothing outside the area, nothing else changed.

#include "gpu/dimmer.hpp"
#include "gpu/readback.hpp"
#include "tests/support/gl_fixture.hpp"

#include <cmath>

namespace autostereo::test {
namespace {

class DimmerGlTest : public GlTest {};

TEST_F(DimmerGlTest, EveryLevelIsMultipliedInsideTheAreaOnly) {
    constexpr int kWidth = 256, kHeight = 8;
    std::vector<std::uint8_t> pixels;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            for (const int level : {x, 255 - x, 3 * x % 256, 255})
                pixels.push_back(static_cast<std::uint8_t>(level));
    const gpu::gl::Texture target(GL_RGBA8, kWidth, kHeight);
    const gpu::gl::Framebuffer panel = gpu::gl::makeFramebuffer(target);
    gpu::Dimmer dimmer;
    for (const double brightness : {0.0, 0.25, 0.5, 0.999, 1.0}) {
        glTextureSubImage2D(target.name(), 0, 0, 0, kWidth, kHeight, GL_RGBA, GL_UNSIGNED_BYTE,
                            pixels.data());
        dimmer.dim(panel.name(), {0, 0, kWidth / 2, kHeight - 1}, brightness);
        const gpu::RgbImage image = gpu::readFramebuffer(panel.name(), kWidth, kHeight);
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x)
                for (int c = 0; c < 3; ++c) {
                    const bool dimmed = x < kWidth / 2 && y > 0; // the top row stays
                    const auto at = static_cast<std::size_t>(y * kWidth + x);
                    const double level = pixels[4 * at + static_cast<std::size_t>(c)];
                    // Blending is rounded once, by fixed point or float: within one level.
                    ASSERT_NEAR(image.pixels[3 * at + static_cast<std::size_t>(c)],
                                dimmed ? brightness * level : level, dimmed ? 1.0 : 0.0)
                        << x << ' ' << y << ' ' << brightness;
                }
    }
    EXPECT_EQ(glIsEnabled(GL_BLEND), GL_FALSE) << "other passes do not blend";
}

} // namespace
} // namespace autostereo::test
