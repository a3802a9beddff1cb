#include "devices/frame_pool.hpp"
#include "devices/record/recording_ring.hpp"
#include "devices/record/recording_source.hpp"
#include "devices/sim/simulation.hpp"
#include "tests/support/fake_source.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/unit/replay/playing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

namespace autostereo {
namespace {

using devices::RecordedStream;
using devices::RecordingRing;
using devices::TimePoint;
using namespace std::chrono_literals;

constexpr std::size_t kDepthBytes = std::size_t{4} * 3 * 2; // of a tiny frame

/// Offers depth frames at these times.
void offer(RecordingRing& ring, const std::vector<devices::Duration>& times) {
    devices::FramePool pool(1);
    for (const devices::Duration time : times)
        ring.offer(RecordedStream::Depth,
                   test::tinyFrame(pool, devices::PixelFormat::Depth16, TimePoint(time)));
}

TEST(RecordingRing, HoldsTheLastSecondsAndNoMore) {
    RecordingRing ring({1s});
    offer(ring, test::regularTimes(300, 33ms));
    const auto held = ring.held();
    ASSERT_EQ(held.pictures.size(), 31U); // 0, 33 ... 990 ms before the last
    EXPECT_EQ(held.pictures.back()->form.capturedAt, TimePoint(299 * 33ms));
    EXPECT_EQ(held.pictures.front()->form.capturedAt, TimePoint(269 * 33ms));
}

TEST(RecordingRing, HoldsNoMoreBytesThanItMay) {
    RecordingRing ring({600s, 10 * kDepthBytes + 1});
    offer(ring, test::regularTimes(300, 33ms));
    EXPECT_EQ(ring.held().pictures.size(), 10U);
    RecordingRing none({600s, kDepthBytes - 1});
    offer(none, test::regularTimes(3, 33ms));
    EXPECT_TRUE(none.held().pictures.empty());
}

TEST(RecordingRing, AClockThatIsSetBackHoldsNothingForEver) {
    RecordingRing ring({1s});
    offer(ring, test::regularTimes(30, 33ms, 1h));
    offer(ring, test::regularTimes(2, 33ms));
    EXPECT_EQ(ring.held().pictures.size(), 2U);
}

TEST(RecordingRing, OtherCamerasStartAnew) {
    RecordingRing ring({1s});
    offer(ring, test::regularTimes(3, 33ms));
    ring.begin({});
    EXPECT_TRUE(ring.held().pictures.empty());
}

TEST(RecordingRing, WhatItHandsOutPlaysAsItWas) {
    const std::string uri = "sim:room?depth=176x144&color=64x48&frames=40";
    auto ring = std::make_shared<RecordingRing>(devices::RingParams{500ms});
    devices::Input input = devices::sim::openSimulation(uri);
    ring->begin(devices::headOf(input));
    const devices::Input tapped = devices::recorded(std::move(input), ring);
    for (int i = 0; i < 40; ++i) {
        ASSERT_TRUE(test::nextFrame(*tapped.depth));
        ASSERT_TRUE(test::nextFrame(*tapped.color));
    }
    const auto bytes = devices::recordingOf(ring->held());
    const test::ScratchFolder folder;
    const std::string file = folder.write("last.mkv", {bytes.begin(), bytes.end()}).string();

    const devices::Input played = devices::openInput(file);
    const devices::Input original = devices::sim::openSimulation(uri);
    constexpr int kHeld = 15; // of 30 a second, and colour is 4 ms later
    for (int i = 0; i < 40 - kHeld; ++i)
        ASSERT_TRUE(test::nextFrame(*original.depth));
    for (int i = 0; i < kHeld; ++i) {
        const auto was = test::nextFrame(*original.depth), is = test::nextFrame(*played.depth);
        ASSERT_TRUE(was && is) << i;
        EXPECT_TRUE(std::ranges::equal(was->depth(), is->depth())) << i;
        EXPECT_TRUE(std::ranges::equal(was->amplitude(), is->amplitude())) << i;
    }
    EXPECT_FALSE(test::nextFrame(*played.depth));
    int colors = 0;
    while (test::nextFrame(*played.color))
        ++colors;
    EXPECT_EQ(colors, kHeld + 1);
    ASSERT_TRUE(played.rig);
    EXPECT_EQ(played.rig->depth.intrinsics.fx, original.rig->depth.intrinsics.fx);
}

TEST(RecordingRing, AFolderThatIsNotThereIsAnError) {
    RecordingRing ring({1s});
    offer(ring, test::regularTimes(3, 33ms));
    EXPECT_THROW(devices::writeRecording(ring.held(), "/nowhere/last.mkv"),
                 devices::RecordingError);
}

} // namespace
} // namespace autostereo
