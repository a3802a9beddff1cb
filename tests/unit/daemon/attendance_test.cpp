#include "daemon/session/attendance.hpp"

#include "devices/frame_pool.hpp"

#include <gtest/gtest.h>

#include <algorithm>

using namespace std::chrono_literals;

namespace autostereo::daemon {
namespace {

/// 100 pixels, a depth camera of 1 mm steps; somebody is there who covers 5 of them within 1.5 m.
struct AttendanceTest : testing::Test {
    AttendanceTest() {
        params.presenceM = 1.5;
        params.presenceShare = 0.05;
        params.leave = 10s;
        tuesday.tm_wday = 2;
        tuesday.tm_hour = 12;
    }
    void watch(devices::Duration time, int nearPixels, std::uint16_t nearCount = 1499) {
        devices::FrameMetadata metadata;
        metadata.format = devices::PixelFormat::Depth16;
        metadata.width = metadata.height = 10;
        auto frame = pool.acquire(metadata);
        std::ranges::fill(frame->depth(), std::uint16_t{3000});
        std::fill_n(frame->depth().begin(), nearPixels, nearCount);
        attendance->saw(*frame, devices::TimePoint(time));
    }
    std::optional<Shown> at(devices::Duration time) const {
        return attendance->rest(devices::TimePoint(time), tuesday);
    }

    config::RestParams params;
    std::tm tuesday{};
    devices::FramePool pool{2};
    std::optional<Attendance> attendance;
};

TEST_F(AttendanceTest, NobodyForSoLongAndBackWithTheFirstFrame) {
    attendance.emplace(params, devices::TimePoint(0s));
    for (auto time = 0ms; time <= 10s; time += 100ms) {
        watch(time, 4);
        EXPECT_EQ(at(time), std::nullopt);
    }
    watch(10100ms, 4);
    EXPECT_EQ(at(10100ms), Shown::Nobody);
    watch(10133ms, 5);
    EXPECT_EQ(at(10133ms), std::nullopt) << "at once";
    watch(10166ms, 0);
    EXPECT_EQ(at(10166ms), std::nullopt) << "and again for so long";
}

TEST_F(AttendanceTest, WhatIsNoMeasurementOrTooFarIsNobody) {
    attendance.emplace(params, devices::TimePoint(0s));
    for (auto time = 0ms; time <= 11s; time += 500ms) {
        const std::array<std::uint16_t, 3> others{0, 65535, 1500};
        watch(time, 100, others.at(static_cast<std::size_t>(time / 500ms) % 3));
    }
    EXPECT_EQ(at(11s), Shown::Nobody);
}

TEST_F(AttendanceTest, WithoutDepthNobodyIsSaidToBeMissing) {
    attendance.emplace(params, devices::TimePoint(0s));
    EXPECT_EQ(at(100s), std::nullopt) << "no frame ever";
    watch(100s, 0);
    EXPECT_EQ(at(101s), std::nullopt) << "the first one only now";
    for (auto time = 100s; time <= 115s; ++time)
        watch(time, 0);
    EXPECT_EQ(at(117s), Shown::Nobody);
    EXPECT_EQ(at(117s + 1ms), std::nullopt) << "the camera is lost: the panel has to say so";
    watch(200s, 0);
    EXPECT_EQ(at(201s), std::nullopt) << "who came meanwhile gets as long as anybody";
}

TEST_F(AttendanceTest, NobodyIsLookedForUnlessAsked) {
    params.presenceM = 0;
    attendance.emplace(params, devices::TimePoint(0s));
    for (auto time = 0s; time <= 100s; ++time)
        watch(time, 0);
    EXPECT_EQ(at(100s), std::nullopt);
    params.presenceM = 1.5;
    attendance->replace(params);
    watch(101s, 0);
    EXPECT_EQ(at(101s), std::nullopt) << "from now on";
}

TEST_F(AttendanceTest, ClosedWhoeverIsThere) {
    params.hours = {*config::openingSpan("tue 09:00-12:00"),
                    *config::openingSpan("wed 12:00-13:00")};
    attendance.emplace(params, devices::TimePoint(0s));
    watch(0s, 100);
    EXPECT_EQ(at(0s), Shown::Closed);
    tuesday.tm_hour = 11;
    tuesday.tm_min = 59;
    EXPECT_EQ(at(0s), std::nullopt);
    tuesday.tm_wday = 0; // Sunday
    EXPECT_EQ(at(0s), Shown::Closed);
}

} // namespace
} // namespace autostereo::daemon
