#include "devices/v4l2/camera_format.hpp"

#include <gtest/gtest.h>

#include <linux/videodev2.h>

#include <vector>

namespace autostereo {
namespace {

using namespace devices::v4l2;
using devices::Duration;
using devices::YuvMatrix;
using devices::YuvRange;

constexpr Duration fps(double rate) { return Duration(static_cast<Duration::rep>(1e9 / rate)); }

/// What a usual webcam on USB 2 offers.
std::vector<Mode> webcam() {
    return {{V4L2_PIX_FMT_YUYV, 640, 480, fps(30)},    {V4L2_PIX_FMT_YUYV, 1280, 720, fps(10)},
            {V4L2_PIX_FMT_YUYV, 1920, 1080, fps(5)},   {V4L2_PIX_FMT_MJPEG, 640, 480, fps(30)},
            {V4L2_PIX_FMT_MJPEG, 1280, 720, fps(30)},  {V4L2_PIX_FMT_MJPEG, 1280, 720, fps(60)},
            {V4L2_PIX_FMT_MJPEG, 1920, 1080, fps(30)}, {V4L2_PIX_FMT_H264, 1280, 720, fps(30)}};
}

TEST(ChooseMode, RateBeforeSizeBeforeFormat) {
    const auto chosen = chooseMode(webcam(), {});
    ASSERT_TRUE(chosen);
    EXPECT_EQ(text(*chosen), "MJPG 1280x720 30 fps");
    ModeRequest full;
    full.width = 1920;
    full.height = 1080;
    EXPECT_EQ(text(*chooseMode(webcam(), full)), "MJPG 1920x1080 30 fps");
    full.framesPerSecond = 5;
    EXPECT_EQ(text(*chooseMode(webcam(), full)), "YUYV 1920x1080 5 fps");
    ModeRequest raw;
    raw.code = V4L2_PIX_FMT_YUYV;
    EXPECT_EQ(text(*chooseMode(webcam(), raw)), "YUYV 640x480 30 fps");
    ModeRequest fast;
    fast.framesPerSecond = 60;
    EXPECT_EQ(text(*chooseMode(webcam(), fast)), "MJPG 1280x720 60 fps");
}

TEST(ChooseMode, ATelevisionRateIsFastEnough) {
    const std::vector<Mode> modes{{V4L2_PIX_FMT_NV12, 1280, 720, fps(29.97)},
                                  {V4L2_PIX_FMT_NV12, 320, 240, fps(30)}};
    EXPECT_EQ(chooseMode(modes, {})->width, 1280);
}

TEST(ChooseMode, WhatDoesNotFitIsNotChosen) {
    ModeRequest absent;
    absent.width = 800;
    EXPECT_FALSE(chooseMode(webcam(), absent));
    ModeRequest depth;
    depth.role = Role::Depth;
    EXPECT_FALSE(chooseMode(webcam(), depth));
    EXPECT_FALSE(chooseMode({}, {}));
    // Shared chroma of an odd number of columns.
    const std::vector<Mode> odd{{V4L2_PIX_FMT_YUYV, 641, 480, fps(30)}};
    EXPECT_FALSE(chooseMode(odd, {}));
    const std::vector<Mode> two{{V4L2_PIX_FMT_Z16, 320, 240, fps(30)},
                                {V4L2_PIX_FMT_Z16, 640, 480, fps(30)}};
    EXPECT_EQ(chooseMode(two, depth)->width, 640);
}

TEST(FourCc, IsReadable) {
    EXPECT_EQ(text(FourCc{V4L2_PIX_FMT_MJPEG}), "MJPG");
    EXPECT_EQ(text(FourCc{V4L2_PIX_FMT_Y16}), "Y16");
    EXPECT_EQ(text(FourCc{0x01020304}), "????");
}

TEST(YuvMeaning, FollowsTheKernelsDefaults) {
    const auto meaning = [](std::uint32_t space, std::uint32_t encoding, std::uint32_t range) {
        return yuvMeaning(space, encoding, range);
    };
    EXPECT_EQ(meaning(V4L2_COLORSPACE_SRGB, 0, 0).matrix, YuvMatrix::Bt601);
    EXPECT_EQ(meaning(V4L2_COLORSPACE_SRGB, 0, 0).range, YuvRange::Limited);
    EXPECT_EQ(meaning(V4L2_COLORSPACE_JPEG, 0, 0).range, YuvRange::Full);
    EXPECT_EQ(meaning(V4L2_COLORSPACE_REC709, 0, 0).matrix, YuvMatrix::Bt709);
    EXPECT_EQ(meaning(0, 0, 0).matrix, YuvMatrix::Auto);
    EXPECT_EQ(meaning(V4L2_COLORSPACE_SRGB, V4L2_YCBCR_ENC_709, V4L2_QUANTIZATION_FULL_RANGE).range,
              YuvRange::Full);
}

} // namespace
} // namespace autostereo
