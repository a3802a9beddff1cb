#include "devices/frame.hpp"
#include "devices/frame_pool.hpp"

#include <gtest/gtest.h>

namespace autostereo::devices {
namespace {

TEST(FrameFormat, SizesAreThoseOfTheFormats) {
    EXPECT_EQ(frameBytes(PixelFormat::Depth16, 6, 4), 48U);
    EXPECT_EQ(frameBytes(PixelFormat::Rgba8, 6, 4), 96U);
    EXPECT_EQ(frameBytes(PixelFormat::Bgra8, 6, 4), 96U);
    EXPECT_EQ(frameBytes(PixelFormat::Rgb8, 5, 3), 45U);
    EXPECT_EQ(frameBytes(PixelFormat::Bgr8, 5, 3), 45U);
    EXPECT_EQ(frameBytes(PixelFormat::Grey8, 5, 3), 15U);
    EXPECT_EQ(frameBytes(PixelFormat::Yuyv, 6, 3), 36U);
    EXPECT_EQ(frameBytes(PixelFormat::Uyvy, 6, 3), 36U);
    EXPECT_EQ(frameBytes(PixelFormat::Nv12, 6, 4), 36U);
}

TEST(FrameFormat, SharedChromaNeedsEvenSides) {
    EXPECT_TRUE(allowsSize(PixelFormat::Rgb8, 5, 3));
    EXPECT_FALSE(allowsSize(PixelFormat::Rgb8, 0, 3));
    EXPECT_TRUE(allowsSize(PixelFormat::Yuyv, 6, 3));
    EXPECT_FALSE(allowsSize(PixelFormat::Yuyv, 5, 3));
    EXPECT_FALSE(allowsSize(PixelFormat::Uyvy, 5, 4));
    EXPECT_TRUE(allowsSize(PixelFormat::Nv12, 6, 4));
    EXPECT_FALSE(allowsSize(PixelFormat::Nv12, 6, 3));
    EXPECT_FALSE(allowsSize(PixelFormat::Nv12, 5, 4));
}

TEST(FrameFormat, APoolsSlotHoldsTheWholeFrame) {
    FramePool pool(1);
    FrameMetadata metadata;
    metadata.format = PixelFormat::Nv12;
    metadata.width = 6;
    metadata.height = 4;
    EXPECT_EQ(pool.acquire(metadata)->pixels().size(), 36U);
}

} // namespace
} // namespace autostereo::devices
