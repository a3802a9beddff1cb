// What goes wrong in the driver, and what becomes of it: a frame that is missing, a stream that has
// to be opened again, a message; never a wrong picture, never a standstill.

#include "devices/live_feed.hpp"
#include "devices/single_stream.hpp"
#include "tests/device/v4l2/reading.hpp"
#include "tests/device/v4l2/vivid.hpp"
#include "tests/support/data.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>

namespace autostereo::test {
namespace {

using namespace std::chrono_literals;

/// 25 frames a second.
constexpr const char* kCamera = "v4l2:/dev/video0?size=640x480&format=YUYV";

class VividFaultsTest : public testing::Test {
  protected:
    void SetUp() override {
        if (!Vivid::there()) GTEST_SKIP() << "no vivid here: run in the guest";
        Vivid::reset();
    }
    void TearDown() override {
        if (Vivid::there()) Vivid::reset();
    }
    static std::string openingError() try {
        const Stream stream(kCamera);
        return "";
    } catch (const devices::DeviceError& error) {
        return error.what();
    }
};

TEST_F(VividFaultsTest, AFrameTheDriverCallsDamagedIsDroppedAndCounted) {
    Stream stream(kCamera);
    ASSERT_FALSE(stream.next().empty());
    Vivid::set("Inject V4L2_BUF_FLAG_ERROR", 1);
    for (int i = 0; i < 8; ++i)
        ASSERT_FALSE(stream.next().empty()) << stream.lost;
    EXPECT_EQ(stream.source->counters().damaged, 1U);
    EXPECT_EQ(stream.source->counters().delivered, 9U);
}

TEST_F(VividFaultsTest, DroppedBuffersAreGapsInTheNumbers) {
    // Not so many that five in a row are missing, which would be a silence.
    Vivid::set("Percentage of Dropped Buffers", 10);
    Stream stream(kCamera);
    const std::uint64_t first = stream.next().metadata().sequence;
    std::uint64_t last = first;
    constexpr std::uint64_t kFrames = 80;
    for (std::uint64_t i = 0; i < kFrames; ++i) {
        const devices::Frame frame = stream.next();
        ASSERT_FALSE(frame.empty()) << stream.lost;
        ASSERT_GT(frame.metadata().sequence, last);
        last = frame.metadata().sequence;
    }
    const std::uint64_t lost = last - first - kFrames;
    EXPECT_GE(lost, 1U) << "of 89 frames that it took to get 80";
    EXPECT_LE(lost, 30U);
    EXPECT_EQ(stream.source->counters().damaged, 0U);
}

TEST_F(VividFaultsTest, AFatalStreamingErrorIsADisconnectionThatReopeningMends) {
    Stream stream(kCamera);
    ASSERT_FALSE(stream.next().empty());
    Vivid::set("Inject Fatal Streaming Error", 1);
    while (!stream.next().empty()) {
    }
    EXPECT_EQ(stream.lost, "/dev/video0: Input/output error");
    stream.source.reset();
    stream.source = stream.reopen();
    EXPECT_FALSE(stream.next().empty()) << stream.lost;
}

TEST_F(VividFaultsTest, ARefusedRequestIsOneLineAndTheNextTryWorks) {
    for (const char* request : {"VIDIOC_REQBUFS", "VIDIOC_STREAMON"}) {
        Vivid::set(std::string("Inject ") + request + " Error", 1);
        const std::string message = openingError();
        EXPECT_NE(message.find(request), std::string::npos) << message;
        EXPECT_NE(message.find("/dev/video0"), std::string::npos) << message;
        EXPECT_EQ(openingError(), "");
    }
}

TEST_F(VividFaultsTest, ABufferThatIsRefusedOnceIsQueuedAgain) {
    Stream stream(kCamera);
    ASSERT_FALSE(stream.next().empty());
    for (int i = 0; i < 10; ++i) { // more often than there are buffers
        Vivid::set("Inject VIDIOC_QBUF Error", 1);
        ASSERT_FALSE(stream.next().empty()) << stream.lost;
        ASSERT_FALSE(stream.next().empty()) << stream.lost;
    }
}

TEST_F(VividFaultsTest, WrappingNumbersAndClocksAreFollowed) {
    Vivid::set("Wrap Sequence Number", 1);
    for (const int wrap : {0, 1, 2}) {
        Vivid::set("Wrap Timestamp", wrap);
        Stream stream(kCamera);
        devices::Frame last = stream.next();
        ASSERT_FALSE(last.empty()) << stream.lost;
        for (int i = 0; i < 100; ++i) { // vivid starts 64 frames before the wrap
            devices::Frame frame = stream.next();
            ASSERT_FALSE(frame.empty()) << stream.lost;
            const auto& now = frame.metadata();
            ASSERT_GT(now.sequence, last.metadata().sequence);
            ASSERT_LT(now.sequence, last.metadata().sequence + 20);
            const auto age = std::chrono::steady_clock::now() - now.capturedAt;
            ASSERT_GE(age, 0ms) << "wrap " << wrap << ", frame " << i;
            ASSERT_LE(age, 600ms) << "wrap " << wrap << ", frame " << i;
            last = std::move(frame);
        }
    }
}

TEST_F(VividFaultsTest, ADisconnectedCameraIsOpenedAgain) {
    Stream stream(kCamera);
    ASSERT_FALSE(stream.next().empty());
    Vivid::set("Disconnect", 1);
    while (!stream.next().empty()) {
    }
    EXPECT_EQ(stream.lost, "/dev/video0: No such device");
    stream.source.reset();
    ASSERT_TRUE(stream.opensAgain());
    EXPECT_FALSE(stream.next().empty()) << stream.lost;
}

TEST_F(VividFaultsTest, ThePictureIsBackTwoSecondsAfterItIsPluggedIn) {
    devices::SteadyClock clock;
    devices::LiveFeed feed(devices::completeStreams(devices::openInput(kCamera)), clock, {}, {});
    ASSERT_TRUE(feed.next(3000ms));
    const int rounds = fullCampaign() ? 50 : 5;
    std::chrono::nanoseconds longest{0};
    for (int i = 0; i < rounds; ++i) {
        Vivid::unbind();
        // The wait between attempts is at its longest by then.
        if (i == 0) std::this_thread::sleep_for(2s);
        const auto plugged = std::chrono::steady_clock::now();
        Vivid::bind();
        while (true) {
            const auto pair = feed.next(5000ms);
            ASSERT_TRUE(pair) << "round " << i;
            if (pair->color.metadata().capturedAt > plugged) break; // not from before
        }
        longest =
            std::max<std::chrono::nanoseconds>(longest, std::chrono::steady_clock::now() - plugged);
    }
    EXPECT_LE(longest, 2s);
    std::cout << rounds << " times, the longest after "
              << std::chrono::duration<double>(longest).count() << " s\n";
    EXPECT_EQ(feed.counters().color.reconnects, static_cast<std::uint64_t>(rounds));
}

} // namespace
} // namespace autostereo::test
