// What differs by noise only is kept byte for byte; what changes is not, however slowly.

#include "devices/frame_pool.hpp"
#include "gpu/color_hold.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace autostereo::test {
namespace {

using devices::PixelFormat;

constexpr int kWidth = 64, kHeight = 48;
constexpr double kSigma = 2;

class ColorHoldTest : public testing::Test {
  protected:
    /// All bytes `level`, with noise.
    devices::Frame frame(PixelFormat format, double level, double sigma) {
        devices::Frame frame = *pool.acquire({format, kWidth, kHeight});
        std::normal_distribution<double> noise(0, std::max(sigma, 1e-9));
        for (std::byte& byte : frame.pixels())
            byte = static_cast<std::byte>(
                std::lround(std::clamp(level + (sigma > 0 ? noise(random) : 0), 0.0, 255.0)));
        return frame;
    }
    static double meanOf(std::span<const std::byte> bytes) {
        double sum = 0;
        for (const std::byte byte : bytes)
            sum += std::to_integer<int>(byte);
        return sum / static_cast<double>(bytes.size());
    }

    devices::FramePool pool{4};
    std::mt19937 random{7};
};

TEST_F(ColorHoldTest, NoiseIsKeptInEveryFormat) {
    for (const PixelFormat format : {PixelFormat::Rgba8, PixelFormat::Rgb8, PixelFormat::Grey8,
                                     PixelFormat::Yuyv, PixelFormat::Nv12}) {
        gpu::ColorHold hold({kSigma});
        EXPECT_TRUE(hold.update(frame(format, 100, kSigma)));
        int renewed = 0;
        for (int i = 0; i < 100; ++i) {
            (void)hold.update(frame(format, 100, kSigma));
            renewed += static_cast<int>(std::ranges::count(hold.renewed(), std::uint8_t{1}));
        }
        // What noise does once in 10^9 times, of 48 blocks in 100 frames; its square's tail is
        // longer.
        EXPECT_LE(renewed, 5);
    }
}

TEST_F(ColorHoldTest, WithoutASigmaEveryByteCounts) {
    gpu::ColorHold hold({0});
    EXPECT_TRUE(hold.update(frame(PixelFormat::Rgba8, 100, 0)));
    EXPECT_FALSE(hold.update(frame(PixelFormat::Rgba8, 100, 0)));
    devices::Frame other = frame(PixelFormat::Rgba8, 100, 0);
    other.pixels()[4 * (kWidth * 20 + 30)] = std::byte{101};
    EXPECT_TRUE(hold.update(other));
    EXPECT_EQ(std::ranges::count(hold.renewed(), std::uint8_t{1}), 1);
    EXPECT_EQ(hold.renewed()[2 * 8 + 3], 1) << "the block of pixel 30, 20";
    EXPECT_TRUE(std::ranges::equal(hold.bytes(), other.pixels()));
}

/// A twentieth of a level a frame: never farther off than the bound that the header states.
TEST_F(ColorHoldTest, AFadeIsFollowed) {
    gpu::ColorHold hold({kSigma});
    const double bound = 6 * std::sqrt(2 * (kSigma * kSigma + 1.0 / 12)) / 8;
    for (int i = 0; i < 1000; ++i) {
        const double level = 80 + 0.05 * i;
        (void)hold.update(frame(PixelFormat::Rgb8, level, kSigma));
        // And the kept mean's own noise, once in 10^9.
        ASSERT_NEAR(meanOf(hold.bytes()), level, bound + 6 * kSigma / 8) << i;
    }
    EXPECT_GT(hold.blocksKept(), hold.blocksSeen() / 2) << "or nothing was tested";
}

TEST_F(ColorHoldTest, AFaintThingInABlockIsSeen) {
    gpu::ColorHold hold({kSigma});
    (void)hold.update(frame(PixelFormat::Grey8, 100, 0));
    devices::Frame thing = frame(PixelFormat::Grey8, 100, 0);
    for (int y = 8; y < 16; ++y) // stripes: the mean is as before
        for (int x = 8; x < 16; ++x)
            thing.pixels()[static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x)] =
                static_cast<std::byte>(x % 2 == 0 ? 94 : 106);
    EXPECT_TRUE(hold.update(thing));
    EXPECT_EQ(std::ranges::count(hold.renewed(), std::uint8_t{1}), 1);
}

TEST_F(ColorHoldTest, AnotherSizeOrFormatRenewsAll) {
    gpu::ColorHold hold({kSigma});
    (void)hold.update(frame(PixelFormat::Rgb8, 100, 0));
    EXPECT_TRUE(hold.update(frame(PixelFormat::Bgr8, 100, 0)));
    EXPECT_EQ(std::ranges::count(hold.renewed(), std::uint8_t{1}), 48);
    devices::Frame odd = *pool.acquire({PixelFormat::Rgb8, 13, 5});
    EXPECT_TRUE(hold.update(odd));
    EXPECT_EQ(hold.renewed().size(), 2U);
    EXPECT_FALSE(hold.update(odd));
}

} // namespace
} // namespace autostereo::test
