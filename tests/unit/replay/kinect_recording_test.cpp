#include "devices/replay/calibration_files.hpp"
#include "devices/replay/kinect_recording.hpp"
#include "tests/support/data.hpp"
#include "tests/unit/replay/playing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>

namespace autostereo {
namespace {

using namespace std::chrono_literals;
using devices::openInput;

std::filesystem::path mug(const char* file) { return test::dataDir() / "k4a-mug" / file; }

TEST(KinectRecording, depthAndInfraredEqualTheReferencePictures) {
    AUTOSTEREO_NEED_DATA("k4a-mug/recording.mkv");
    const auto input = openInput(mug("recording.mkv"));
    ASSERT_TRUE(input.depth);
    const auto frame = test::nextFrame(*input.depth);
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->metadata().width, 640);
    EXPECT_EQ(frame->metadata().height, 576);
    EXPECT_EQ(frame->metadata().depthUnitM, 0.001);
    EXPECT_TRUE(std::ranges::equal(frame->depth(), test::loadImage(mug("depth.png")).counts()));
    ASSERT_TRUE(frame->metadata().hasAmplitude);
    EXPECT_TRUE(std::ranges::equal(frame->amplitude(), test::loadImage(mug("ir.png")).counts()));
    EXPECT_FALSE(test::nextFrame(*input.depth));
    EXPECT_EQ(input.depth->counters().delivered, 1U);
    EXPECT_EQ(input.depth->counters().damaged, 0U);
}

TEST(KinectRecording, colourEqualsTheReferencePicture) {
    AUTOSTEREO_NEED_DATA("k4a-mug/recording.mkv");
    const auto input = openInput(mug("recording.mkv"));
    ASSERT_TRUE(input.color);
    const auto frame = test::nextFrame(*input.color);
    ASSERT_TRUE(frame);
    const auto reference = test::loadImage(mug("color.jpg"));
    EXPECT_EQ(frame->metadata().width, 1280);
    EXPECT_EQ(frame->metadata().height, 720);
    EXPECT_TRUE(std::ranges::equal(frame->pixels(), reference.pixels)); // the same JPEG bytes
    EXPECT_FALSE(test::nextFrame(*input.color));
    EXPECT_EQ(input.color->counters().damaged, 0U);
}

TEST(KinectRecording, timesAreTheDevices) {
    AUTOSTEREO_NEED_DATA("k4a-mug/recording.mkv");
    const auto input = openInput(mug("recording.mkv"));
    EXPECT_EQ(input.startsAt, 800222us);
    EXPECT_EQ(input.nominalPeriod, 200ms);
    EXPECT_EQ(test::nextFrame(*input.depth)->metadata().capturedAt.time_since_epoch(), 800222us);
    EXPECT_EQ(test::nextFrame(*input.color)->metadata().capturedAt.time_since_epoch(), 800222us);
}

TEST(KinectRecording, calibrationIsTheAttachedOne) {
    AUTOSTEREO_NEED_DATA("k4a-mug/recording.mkv");
    const auto input = openInput(mug("recording.mkv"));
    const auto file = devices::readCameraFile(mug("camera.json"));
    ASSERT_TRUE(input.rig);
    EXPECT_NEAR(input.rig->depth.intrinsics.fx, file.depth->intrinsics.fx, 1e-6);
    EXPECT_NEAR(input.rig->color.intrinsics.cy, file.color->intrinsics.cy, 1e-6);
    EXPECT_NEAR(input.rig->colorFromDepth.translation.x, -0.0320834294, 1e-6);
    EXPECT_EQ(input.warnings.size(), 0U);
}

TEST(KinectRecording, rewindPlaysTheSameAgain) {
    AUTOSTEREO_NEED_DATA("k4a-mug/recording.mkv");
    const auto input = openInput(mug("recording.mkv"));
    EXPECT_EQ(test::countFrames(*input.depth), 1);
    ASSERT_TRUE(input.depth->rewind());
    const auto again = test::nextFrame(*input.depth);
    ASSERT_TRUE(again);
    EXPECT_EQ(again->metadata().sequence, 0U);
    EXPECT_TRUE(again->metadata().hasAmplitude);
    EXPECT_EQ(test::countFrames(*input.color), 1);
    ASSERT_TRUE(input.color->rewind());
    EXPECT_EQ(test::countFrames(*input.color), 1);
}

TEST(KinectRecording, aRigForOtherPicturesIsRefused) {
    AUTOSTEREO_NEED_DATA("k4a-mug/recording.mkv");
    auto rig = devices::readCameraFile(mug("camera.json")).rig();
    rig.provenance = "mine";
    EXPECT_EQ(openInput(mug("recording.mkv"), rig).rig->provenance, "mine");
    rig.depth = rig.depth.resized(320, 288);
    EXPECT_THROW(static_cast<void>(openInput(mug("recording.mkv"), rig)), devices::DeviceError);
}

} // namespace
} // namespace autostereo
