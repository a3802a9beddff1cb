// Every format that cameras give becomes the colours that the standards say.

#include "devices/frame_pool.hpp"
#include "gpu/frame_uploader.hpp"
#include "tests/oracle/color_oracle.hpp"
#include "tests/support/gl_fixture.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

namespace autostereo::test {
namespace {

using devices::PixelFormat;
using devices::YuvMatrix;
using devices::YuvRange;

class ColorConverterGlTest : public GlTest {
  protected:
    /// What the uploader makes of these bytes: RGBA, top row first.
    std::vector<std::uint8_t> uploaded(const devices::FrameMetadata& form,
                                       const std::vector<std::byte>& bytes) {
        devices::RgbdFrame frame;
        frame.depth = *pool.acquire({PixelFormat::Depth16, 4, 4});
        frame.color = *pool.acquire(form);
        EXPECT_EQ(frame.color.pixels().size(), bytes.size());
        std::ranges::copy(bytes, frame.color.pixels().begin());
        if (!uploader) uploader.emplace();
        uploader->upload(frame);
        std::vector<std::uint8_t> rgba(4 * frame.color.pixelCount());
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glGetTextureImage(uploader->color().name(), 0, GL_RGBA, GL_UNSIGNED_BYTE,
                          static_cast<GLsizei>(rgba.size()), rgba.data());
        return rgba;
    }
    static devices::FrameMetadata form(PixelFormat format, int width, int height) {
        devices::FrameMetadata metadata;
        metadata.format = format;
        metadata.width = width;
        metadata.height = height;
        return metadata;
    }
    static std::vector<std::byte> bytes(std::initializer_list<int> values) {
        std::vector<std::byte> result;
        result.reserve(values.size());
        for (const int value : values)
            result.push_back(static_cast<std::byte>(value));
        return result;
    }

    devices::FramePool pool{4};
    std::optional<gpu::FrameUploader> uploader; ///< needs the context
};

/// Half a level of rounding, and float against double.
constexpr double kRounding = 0.51;

TEST_F(ColorConverterGlTest, EveryFormatMatrixAndRangeIsAsTheOracleSays) {
    if (IsSkipped()) return;
    std::mt19937 random(21);
    for (const PixelFormat format :
         {PixelFormat::Rgba8, PixelFormat::Bgra8, PixelFormat::Rgb8, PixelFormat::Bgr8,
          PixelFormat::Grey8, PixelFormat::Yuyv, PixelFormat::Uyvy, PixelFormat::Nv12})
        for (const YuvMatrix matrix : {YuvMatrix::Auto, YuvMatrix::Bt601, YuvMatrix::Bt709})
            for (const YuvRange range : {YuvRange::Auto, YuvRange::Limited, YuvRange::Full})
                for (const int height : {6, 720}) {
                    devices::FrameMetadata metadata = form(format, 34, height);
                    metadata.matrix = matrix;
                    metadata.range = range;
                    std::vector<std::byte> raw(devices::frameBytes(format, 34, height));
                    std::ranges::generate(raw, [&] { return static_cast<std::byte>(random()); });
                    const auto rgba = uploaded(metadata, raw);
                    double most = 0;
                    for (int i = 0; i < 34 * height; ++i) {
                        const auto expected =
                            oracle::convertedColor({metadata, raw}, i % 34, i / 34);
                        for (std::size_t c = 0; c < 3; ++c)
                            most =
                                std::max(most, std::abs(rgba[4 * static_cast<std::size_t>(i) + c] -
                                                        expected[c]));
                    }
                    EXPECT_LE(most, kRounding) << "format " << static_cast<int>(format);
                }
}

void expectPixel(const std::vector<std::uint8_t>& rgba, std::size_t pixel, std::array<int, 3> rgb) {
    for (std::size_t c = 0; c < 3; ++c) // 1: the table of 75 % bars is itself rounded
        EXPECT_NEAR(int{rgba[4 * pixel + c]}, rgb[c], 1) << "pixel " << pixel << " channel " << c;
}

TEST_F(ColorConverterGlTest, YuyvIsStudioRangeBt601WhereSmall) {
    if (IsSkipped()) return;
    // White, black; then the 75 % bars red and blue of ITU-R BT.801.
    auto rgba = uploaded(form(PixelFormat::Yuyv, 2, 1), bytes({235, 128, 16, 128}));
    expectPixel(rgba, 0, {255, 255, 255});
    expectPixel(rgba, 1, {0, 0, 0});
    rgba = uploaded(form(PixelFormat::Yuyv, 2, 1), bytes({65, 100, 65, 212}));
    expectPixel(rgba, 0, {191, 0, 0});
    rgba = uploaded(form(PixelFormat::Uyvy, 2, 1), bytes({212, 35, 114, 35}));
    expectPixel(rgba, 1, {0, 0, 191});
}

TEST_F(ColorConverterGlTest, Nv12SharesOneColourAmongFourPixels) {
    if (IsSkipped()) return;
    // 4x2: the left block red, the right one blue; between them chroma goes over.
    const auto rgba = uploaded(form(PixelFormat::Nv12, 4, 2),
                               bytes({65, 65, 35, 35, 65, 65, 35, 35, 100, 212, 212, 114}));
    for (const std::size_t pixel : {0U, 4U})
        expectPixel(rgba, pixel, {191, 0, 0});
    for (const std::size_t pixel : {2U, 3U, 6U, 7U})
        expectPixel(rgba, pixel, {0, 0, 191});
}

TEST_F(ColorConverterGlTest, FullRangeHasNoHeadroom) {
    if (IsSkipped()) return;
    devices::FrameMetadata metadata = form(PixelFormat::Yuyv, 2, 1);
    metadata.range = YuvRange::Full;
    const auto rgba = uploaded(metadata, bytes({255, 128, 0, 128}));
    expectPixel(rgba, 0, {255, 255, 255});
    expectPixel(rgba, 1, {0, 0, 0});
}

} // namespace
} // namespace autostereo::test
