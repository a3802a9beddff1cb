#include "devices/frame_pool.hpp"
#include "devices/replay/grey_image.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace autostereo::devices {
namespace {

constexpr int kWidth = 8, kHeight = 4;

Frame frameOf(PixelFormat format) {
    static FramePool pool(16);
    FrameMetadata metadata;
    metadata.format = format;
    metadata.width = kWidth;
    metadata.height = kHeight;
    Frame frame = std::move(*pool.acquire(metadata));
    std::ranges::fill(frame.pixels(), std::byte{200}); // also of what carries no brightness
    return frame;
}

std::uint16_t ramp(std::size_t pixel) { return static_cast<std::uint16_t>(16 + 5 * pixel); }

/// A grey ramp in a format whose pixel keeps its brightness at these offsets.
void expectRamp(PixelFormat format, std::size_t stride, std::initializer_list<std::size_t> at) {
    Frame frame = frameOf(format);
    for (std::size_t pixel = 0; pixel < kWidth * kHeight; ++pixel)
        for (const std::size_t offset : at)
            frame.pixels()[pixel * stride + offset] = static_cast<std::byte>(ramp(pixel));
    const GreyPixels grey = greyOf(frame);
    ASSERT_EQ(grey.width, kWidth);
    ASSERT_EQ(grey.height, kHeight);
    ASSERT_EQ(grey.values.size(), std::size_t{kWidth * kHeight});
    for (std::size_t pixel = 0; pixel < grey.values.size(); ++pixel)
        EXPECT_EQ(grey.values[pixel], ramp(pixel)) << pixel;
}

TEST(GreyImage, EveryColourFormatHasABrightness) {
    expectRamp(PixelFormat::Rgba8, 4, {0, 1, 2});
    expectRamp(PixelFormat::Bgra8, 4, {0, 1, 2});
    expectRamp(PixelFormat::Rgb8, 3, {0, 1, 2});
    expectRamp(PixelFormat::Bgr8, 3, {0, 1, 2});
    expectRamp(PixelFormat::Grey8, 1, {0});
    expectRamp(PixelFormat::Yuyv, 2, {0});
    expectRamp(PixelFormat::Uyvy, 2, {1});
    expectRamp(PixelFormat::Nv12, 1, {0});
}

TEST(GreyImage, ColoursWeighAsTheEyeSeesThem) {
    Frame frame = frameOf(PixelFormat::Bgr8);
    for (std::size_t i = 0; i < frame.pixels().size(); i += 3)
        frame.pixels()[i] = frame.pixels()[i + 1] = std::byte{0}; // red 200
    EXPECT_EQ(greyOf(frame).values.front(), 60) << "0.299 x 200";
}

TEST(GreyImage, DepthHasNone) { EXPECT_TRUE(greyOf(frameOf(PixelFormat::Depth16)).values.empty()); }

} // namespace
} // namespace autostereo::devices
