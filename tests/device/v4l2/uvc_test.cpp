// A UVC camera on the kernel's own driver: pictures, controls, times.

#include "devices/replay/jpeg_decoder.hpp"
#include "devices/v4l2/camera_report.hpp"
#include "tests/device/v4l2/uvc_fixture.hpp"
#include "tests/support/data.hpp"

#include <algorithm>
#include <iostream>
#include <numeric>
#include <span>
#include <vector>

namespace autostereo::test {
namespace {

using namespace std::chrono_literals;

double milliseconds(std::chrono::nanoseconds time) {
    return std::chrono::duration<double, std::milli>(time).count();
}

TEST_F(UvcTest, FramesComeWholeInOrderBothWays) {
    for (const bool isochronous : {false, true}) {
        SCOPED_TRACE(isochronous ? "isochronous" : "bulk");
        plugIn(isochronous);
        Stream stream(std::string(kAddress) + "?format=YUYV");
        EXPECT_EQ(stream.input.description, "Emulated camera, YUYV 320x240 30 fps");
        int luma = -1;
        for (int i = 0; i < 20; ++i) {
            const devices::Frame frame = stream.next();
            ASSERT_FALSE(frame.empty()) << stream.lost;
            ASSERT_TRUE(isWhole(frame)) << "frame " << i;
            const int seen = std::to_integer<int>(frame.pixels()[0]);
            EXPECT_TRUE(luma < 0 || seen == luma + 1) << luma << " then " << seen;
            luma = seen;
        }
        stream.source.reset();
        unplug();
    }
}

TEST_F(UvcTest, TheFrameRateHasPriorityAndControlsAreSet) {
    plugIn();
    const Stream stream(std::string(kAddress) + "?exposure_ms=8&power_line=50&white_balance=5000");
    EXPECT_EQ(camera->control(0x0103), 0) << "the rate may not fall in the dark";
    EXPECT_EQ(camera->control(0x0102), 1) << "manual exposure";
    EXPECT_EQ(camera->control(0x0104), 80) << "8 ms";
    EXPECT_EQ(camera->control(0x0205), 1) << "50 Hz";
    EXPECT_EQ(camera->control(0x020b), 0) << "white balance is not automatic";
    EXPECT_EQ(camera->control(0x020a), 5000);
}

TEST_F(UvcTest, CamerasAreListedWithTheirModes) {
    plugIn();
    const auto reports = devices::v4l2::reportCameras();
    ASSERT_EQ(reports.size(), 2U) << "vivid and this one, without its node for metadata";
    const auto& report = reports.back();
    EXPECT_EQ(report.node.name, "Emulated camera");
    EXPECT_EQ(report.node.serial, "UVC0001");
    EXPECT_EQ(report.node.usbMbps, 480);
    EXPECT_TRUE(report.node.bus.starts_with("usb-vhci_hcd.0-")) << report.node.bus;
    ASSERT_EQ(report.modes.size(), 2U);
    EXPECT_EQ(text(report.modes.front()), "YUYV 320x240 30 fps");
    EXPECT_EQ(text(report.modes.back()), "MJPG 1920x1080 30 fps");
    EXPECT_TRUE(report.problems.empty());
    // The name that is listed opens it.
    Stream stream("v4l2:" + report.node.bus + "?format=YUYV");
    EXPECT_FALSE(stream.next().empty()) << stream.lost;
}

TEST_F(UvcTest, WhatTheCameraRefusesIsSaid) {
    plugIn();
    const Stream stream(std::string(kAddress) + "?white_balance=9000&format=YUYV");
    // The kernel itself clamps numbers; it refuses what the camera doesn't have.
    const Stream vivid("v4l2:/dev/video0?power_line=50");
    const auto& warnings = vivid.input.warnings;
    EXPECT_TRUE(std::ranges::any_of(warnings, [](const std::string& warning) {
        return warning.find("refuses that power line frequency") != std::string::npos;
    }));
}

/// How long this machine takes to decode one of the camera's pictures, the median of 15.
double decodeMs(std::span<const std::uint8_t> jpeg) {
    devices::JpegDecoder decoder;
    std::vector<std::byte> pixels;
    std::vector<double> times;
    for (int i = 0; i < 15; ++i) {
        const auto started = std::chrono::steady_clock::now();
        pixels.resize(decoder.open(std::as_bytes(jpeg)).bytes());
        decoder.decode(pixels);
        times.push_back(milliseconds(std::chrono::steady_clock::now() - started));
    }
    std::ranges::sort(times);
    return times[times.size() / 2];
}

// The guest has one processor for camera, kernel and reader. Where other programs leave it so
// little that decoding alone takes a third of the period, the camera runs slower.
TEST_F(UvcTest, FullHdJpegAtFullRateLosesNothing) {
    plugIn();
    const double decoding = decodeMs(jpegPicture(1920, 1080, 0));
    const int rate = decoding < 11 ? 30 : decoding < 22 ? 15 : 5;
    Stream stream(std::string(kAddress) +
                  "?format=MJPG&size=1920x1080&fps=" + std::to_string(rate));
    // While controls are set nobody reads, and the camera has but four buffers.
    for (int i = 0; i < 15; ++i)
        ASSERT_FALSE(stream.next().empty()) << stream.lost;
    const auto duration = fullCampaign() ? 60s : 5s;
    const unsigned sentBefore = camera->framesSent();
    std::vector<double> intervals, lags;
    auto last = stream.next().metadata();
    const auto end = std::chrono::steady_clock::now() + duration;
    std::uint64_t gaps = 0;
    while (std::chrono::steady_clock::now() < end) {
        const devices::Frame frame = stream.next();
        ASSERT_FALSE(frame.empty()) << stream.lost;
        const auto& now = frame.metadata();
        EXPECT_EQ(now.width, 1920);
        if (now.sequence != last.sequence + 1)
            std::cout << now.sequence - last.sequence - 1 << " lost after " << intervals.size()
                      << '\n';
        gaps += now.sequence - last.sequence - 1;
        intervals.push_back(milliseconds(now.capturedAt - last.capturedAt));
        lags.push_back(milliseconds(std::chrono::steady_clock::now() - now.capturedAt));
        last = now;
    }
    const unsigned sent = camera->framesSent() - sentBefore;
    const auto counters = stream.source->counters();
    std::ranges::sort(intervals);
    std::cout << rate << " frames a second, " << decoding << " ms to decode one: " << sent
              << " frames sent, " << intervals.size() << " read; interval " << intervals.front()
              << " / " << intervals[intervals.size() / 2] << " / " << intervals.back()
              << " ms; lag from mid-exposure "
              << std::accumulate(lags.begin(), lags.end(), 0.0) / static_cast<double>(lags.size())
              << " ms mean, " << *std::ranges::max_element(lags) << " ms at most\n";
    EXPECT_EQ(gaps, 0U);
    EXPECT_EQ(counters.damaged, 0U);
    EXPECT_EQ(counters.starved, 0U);
    // Two may be on their way at either end.
    EXPECT_NEAR(static_cast<double>(intervals.size()), sent, 3);
    // The camera's own clock: the middle half is within a millisecond of its period on a free
    // machine.
    EXPECT_NEAR(intervals[intervals.size() / 2], 1000.0 / rate, 2);
}

} // namespace
} // namespace autostereo::test
