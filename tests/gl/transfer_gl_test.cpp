// Pixels on their way to the GPU and back keep their place and value.

#include "devices/frame_pool.hpp"
#include "gpu/frame_uploader.hpp"
#include "gpu/readback.hpp"
#include "tests/support/gl_fixture.hpp"

#include <array>
#include <random>

namespace autostereo::test {
namespace {

class TransferGlTest : public GlTest {};

TEST_F(TransferGlTest, ReadbackTurnsRowsOver) {
    const gpu::gl::Texture target(GL_RGBA8, 5, 4);
    const gpu::gl::Framebuffer framebuffer = gpu::gl::makeFramebuffer(target);
    std::vector<std::uint8_t> texels;
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 5; ++x)
            for (const int value : {10 * x, 20 * y, 7, 255})
                texels.push_back(static_cast<std::uint8_t>(value));
    glTextureSubImage2D(target.name(), 0, 0, 0, 5, 4, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    const gpu::RgbImage image = gpu::readFramebuffer(framebuffer.name(), 5, 4);
    for (std::size_t y = 0; y < 4; ++y)
        for (std::size_t x = 0; x < 5; ++x) {
            const std::size_t at = 3 * (5 * y + x);
            EXPECT_EQ(image.pixels[at], 10 * x);
            EXPECT_EQ(image.pixels[at + 1], 20 * (3 - y)) << "row 0 of GL is the image's last";
        }
    const gpu::RgbImage part = gpu::crop(image, 3, 1, 2, 2);
    EXPECT_EQ(part.pixels[0], 30);
    EXPECT_EQ(part.pixels[1], 40);
    EXPECT_EQ(part.pixels.size(), 12U);
}

/// Odd sizes, more frames than the ring has buffers, a size that changes on the way.
TEST_F(TransferGlTest, UploadsEveryBit) {
    devices::FramePool pool(4);
    gpu::FrameUploader uploader;
    std::mt19937 random(5);
    for (int round = 0; round < 9; ++round) {
        const int width = round < 5 ? 33 : 70, height = 19;
        devices::RgbdFrame frame;
        frame.depth = *pool.acquire({devices::PixelFormat::Depth16, width, height});
        frame.color = *pool.acquire({devices::PixelFormat::Rgba8, width, height});
        for (auto& count : frame.depth.depth())
            count = static_cast<std::uint16_t>(random());
        for (auto& byte : frame.color.pixels())
            byte = static_cast<std::byte>(random());
        uploader.upload(frame);

        std::vector<std::uint16_t> counts(frame.depth.pixelCount());
        std::vector<std::byte> bytes(4 * frame.color.pixelCount());
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glGetTextureImage(uploader.depth().name(), 0, GL_RED_INTEGER, GL_UNSIGNED_SHORT,
                          static_cast<GLsizei>(2 * counts.size()), counts.data());
        glGetTextureImage(uploader.color().name(), 0, GL_RGBA, GL_UNSIGNED_BYTE,
                          static_cast<GLsizei>(bytes.size()), bytes.data());
        EXPECT_TRUE(std::equal(counts.begin(), counts.end(), frame.depth.depth().begin()));
        EXPECT_TRUE(std::equal(bytes.begin(), bytes.end(), frame.color.pixels().begin()));
    }
}

} // namespace
} // namespace autostereo::test
