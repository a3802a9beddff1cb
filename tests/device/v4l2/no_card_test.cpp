// Where no GPU could take a camera's pictures as they lie, they are copied, and are the same.

#include "devices/frame_pool.hpp"
#include "gpu/frame_uploader.hpp"
#include "tests/device/v4l2/reading.hpp"
#include "tests/device/v4l2/vivid.hpp"
#include "tests/oracle/color_oracle.hpp"
#include "tests/support/gl_fixture.hpp"

#include <cmath>
#include <filesystem>

namespace autostereo::test {
namespace {

using NoCardTest = GlTest;

TEST_F(NoCardTest, PicturesAreCopiedAndTheSame) {
    if (!Vivid::there()) GTEST_SKIP() << "no vivid here: run in the guest";
    if (IsSkipped()) return;
    ASSERT_FALSE(std::filesystem::exists("/dev/dri"));
    Vivid::reset();
    gpu::FrameUploader uploader;
    devices::FramePool pool(1);
    devices::RgbdFrame pair;
    pair.depth = *pool.acquire({devices::PixelFormat::Depth16, 4, 4});
    Stream stream("v4l2:/dev/video0?format=YUYV&size=640x480");
    for (int i = 0; i < 4; ++i) {
        pair.color = stream.next();
        ASSERT_FALSE(pair.color.empty()) << stream.lost;
        ASSERT_TRUE(pair.color.shared()) << "the camera could do without";
        uploader.upload(pair);
        EXPECT_TRUE(pair.color.shared()->sharing->answered());
        EXPECT_EQ(uploader.colorWay(), devices::PixelWay::Copied);
    }
    const devices::FrameMetadata form = pair.color.metadata();
    const std::vector<std::byte> bytes(pair.color.pixels().begin(), pair.color.pixels().end());
    std::vector<std::uint8_t> rgba(4 * pair.color.pixelCount());
    glGetTextureImage(uploader.color().name(), 0, GL_RGBA, GL_UNSIGNED_BYTE,
                      static_cast<GLsizei>(rgba.size()), rgba.data());
    double most = 0;
    for (int p = 0; p < form.width * form.height; ++p) {
        const auto expected = oracle::convertedColor({form, bytes}, p % form.width, p / form.width);
        for (std::size_t c = 0; c < 3; ++c)
            most =
                std::max(most, std::abs(rgba[4 * static_cast<std::size_t>(p) + c] - expected[c]));
    }
    EXPECT_LE(most, 0.51); // half a level of rounding, and float against double
}

} // namespace
} // namespace autostereo::test
