// 2D-plus-depth frames: the picture squeezed into the left half, disparity as grey into the right
// half, the header in the blue of the top row.

#include "calib/depth_frame_header.hpp"
#include "gpu/interleaver.hpp"
#include "gpu/readback.hpp"
#include "tests/support/gl_fixture.hpp"

#include <algorithm>
#include <cmath>

namespace autostereo::test {
namespace {

constexpr int kWidth = 640, kHeight = 360; // of the panel; tiles have the half frame's size
constexpr int kTile = kWidth / 2;

class DepthFrameGlTest : public GlTest {
  protected:
    static std::uint8_t colorAt(int x, int yUp, int c) {
        return static_cast<std::uint8_t>((3 * x + 5 * yUp + 70 * c) % 256);
    }
    static float disparityAt(int x, int yUp) {
        return 0.0002F * static_cast<float>(x - kTile / 2) + 0.0001F * static_cast<float>(yUp);
    }

    static gpu::RgbImage packed(const calib::DepthFrame& frame) {
        gpu::Atlas atlas({1, {1, 1, kTile, kHeight}});
        std::vector<std::uint8_t> texels;
        std::vector<float> disparities;
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kTile; ++x) {
                for (int c = 0; c < 3; ++c)
                    texels.push_back(colorAt(x, y, c));
                texels.push_back(255);
                disparities.push_back(disparityAt(x, y));
            }
        glTextureSubImage2D(atlas.color().name(), 0, 0, 0, kTile, kHeight, GL_RGBA,
                            GL_UNSIGNED_BYTE, texels.data());
        const gpu::gl::Texture disparity(GL_R32F, kTile, kHeight);
        glTextureSubImage2D(disparity.name(), 0, 0, 0, kTile, kHeight, GL_RED, GL_FLOAT,
                            disparities.data());
        const gpu::gl::Texture target(GL_RGBA8, kWidth, kHeight);
        const gpu::gl::Framebuffer panel = gpu::gl::makeFramebuffer(target);
        gpu::makeInterleaver(frame, kWidth, kHeight, {})
            ->render({&atlas, &disparity}, panel.name());
        return gpu::readFramebuffer(panel.name(), kWidth, kHeight);
    }
    static int at(const gpu::RgbImage& image, int x, int y, int c) {
        return image
            .pixels[3 * static_cast<std::size_t>(y * kWidth + x) + static_cast<std::size_t>(c)];
    }
};

TEST_F(DepthFrameGlTest, HalvesAndHeader) {
    calib::DepthFrame frame;
    frame.gain = 1500;
    const gpu::RgbImage image = packed(frame);
    const auto header = calib::depthFrameHeaderRow(frame);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            for (int c = 0; c < 3; ++c) {
                const int yUp = kHeight - 1 - y;
                if (y == 0 && c == 2 && x < 256) {
                    ASSERT_EQ(at(image, x, y, c), header[static_cast<std::size_t>(x)]) << x;
                } else if (x < kTile) {
                    ASSERT_EQ(at(image, x, y, c), colorAt(x, yUp, c)) << x << ' ' << y;
                } else {
                    // Float on the GPU: at most one rounding from the exact grey.
                    const double grey = 127.5 + 1500.0 * disparityAt(x - kTile, yUp);
                    ASSERT_NEAR(at(image, x, y, c), std::clamp(grey, 0.0, 255.0), 0.501)
                        << x << ' ' << y;
                }
            }
}

TEST_F(DepthFrameGlTest, TheHeaderCanBeLeftOut) {
    calib::DepthFrame frame;
    frame.gain = 1500;
    frame.header = false;
    const gpu::RgbImage image = packed(frame);
    for (int x = 0; x < kTile; ++x)
        ASSERT_EQ(at(image, x, 0, 2), colorAt(x, kHeight - 1, 2)) << x;
}

} // namespace
} // namespace autostereo::test
