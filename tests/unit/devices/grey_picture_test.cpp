#include "devices/frame_pool.hpp"
#include "devices/grey_picture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numbers>
#include <vector>

using namespace autostereo;
using namespace autostereo::devices;

namespace {

constexpr int kWidth = 64;
constexpr int kHeight = 48;

std::size_t indexOf(int x, int y) {
    return static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x);
}

calib::CameraModel camera() {
    calib::CameraModel model;
    model.intrinsics = {.width = kWidth,
                        .height = kHeight,
                        .fx = 60,
                        .fy = 60,
                        .cx = (kWidth - 1) / 2.0,
                        .cy = (kHeight - 1) / 2.0};
    return model;
}

/// Grey levels of a depth picture given in millimetres for each pixel.
std::vector<int> greyOf(const std::function<int(int x, int y)>& depthMm) {
    FramePool pool(2);
    FrameMetadata metadata;
    metadata.format = PixelFormat::Depth16;
    metadata.width = kWidth;
    metadata.height = kHeight;
    Frame depth = std::move(*pool.acquire(metadata));
    metadata.format = PixelFormat::Rgba8;
    Frame color = std::move(*pool.acquire(metadata));
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            depth.depth()[indexOf(x, y)] = static_cast<std::uint16_t>(depthMm(x, y));
    GreyPicture(camera()).paint(depth, color);
    std::vector<int> grey;
    for (std::size_t i = 0; i < color.pixels().size(); i += 4) {
        EXPECT_EQ(color.pixels()[i], color.pixels()[i + 1]);
        EXPECT_EQ(color.pixels()[i], color.pixels()[i + 2]);
        EXPECT_EQ(color.pixels()[i + 3], std::byte{255});
        grey.push_back(static_cast<int>(color.pixels()[i]));
    }
    return grey;
}

int centre(const std::vector<int>& grey) { return grey[indexOf(kWidth / 2, kHeight / 2)]; }

TEST(GreyPicture, FadesWithTheDistance) {
    // light = 3 m / (3 m + z) on a wall that faces the camera; half a pixel off the axis
    EXPECT_NEAR(centre(greyOf([](int, int) { return 1000; })), 255.0 * 3 / 4, 1.0);
    EXPECT_NEAR(centre(greyOf([](int, int) { return 3000; })), 255.0 / 2, 1.0);
}

TEST(GreyPicture, IsDarkerWhereTheSurfaceTurnsAway) {
    // The plane z = z0 + x tan(60 deg) through the axis at 2 m: z = z0 / (1 - tan(60 deg) x').
    const double slope = std::tan(std::numbers::pi / 3);
    const auto grey = greyOf([&](int x, int) {
        const double ray = (x - (kWidth - 1) / 2.0) / 60;
        return static_cast<int>(std::clamp(2000 / (1 - slope * ray), 1.0, 60000.0));
    });
    const double light = (0.2 + 0.8 * std::cos(std::numbers::pi / 3)) * 3 / 5;
    // Half a pixel off the axis turns the line of sight by half a degree (1.5 % of the cosine);
    // whole millimetres tilt the plane by as much again.
    EXPECT_NEAR(centre(grey), 255 * light, 4.0);
}

TEST(GreyPicture, IsBlackWhereThereIsNoMeasurement) {
    const auto grey = greyOf([](int x, int y) { return y == 3 ? (x % 2 == 0 ? 0 : 65535) : 1500; });
    for (int x = 0; x < kWidth; ++x) {
        EXPECT_EQ(grey[indexOf(x, 3)], 0);
        EXPECT_GT(grey[indexOf(x, 4)], 100);
    }
}

TEST(GreyPicture, AnEdgeBetweenSurfacesIsNotASlope) {
    const auto grey = greyOf([](int x, int) { return x < kWidth / 2 ? 1000 : 3000; });
    EXPECT_NEAR(grey[indexOf(kWidth / 2 - 1, kHeight / 2)], 255.0 * 3 / 4, 1.0);
    EXPECT_NEAR(grey[indexOf(kWidth / 2, kHeight / 2)], 255.0 / 2, 1.0);
}

TEST(GreyPicture, TakesFramesOfAnotherSizeThanTheCamera) {
    FramePool pool(2);
    FrameMetadata metadata;
    metadata.format = PixelFormat::Depth16;
    GreyPicture picture(camera());
    for (const int width : {32, 96, 1}) {
        metadata.format = PixelFormat::Depth16;
        metadata.width = width;
        metadata.height = 24;
        Frame depth = std::move(*pool.acquire(metadata));
        std::ranges::fill(depth.depth(), std::uint16_t{1000});
        metadata.format = PixelFormat::Rgba8;
        Frame color = std::move(*pool.acquire(metadata));
        picture.paint(depth, color);
        EXPECT_GT(static_cast<int>(color.pixels()[0]), 0) << width;
    }
}

} // namespace
