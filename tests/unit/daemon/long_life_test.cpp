// Ten years of uptime and counters beyond what 32 bits or a double's mantissa hold: nothing is any
// different from the first day.

#include "daemon/session/report.hpp"
#include "daemon/session/show_policy.hpp"
#include "devices/frame_sync.hpp"
#include "devices/paced_source.hpp"
#include "devices/sequence_counter.hpp"
#include "tests/support/fake_clock.hpp"
#include "tests/support/fake_source.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <random>

namespace autostereo::test {
namespace {

using namespace std::chrono_literals;
using devices::Duration;
using devices::TimePoint;

constexpr Duration kTenYears = std::chrono::hours(10L * 365 * 24 + 1) + 7ns;
constexpr std::array<std::uint64_t, 3> kCounts{(1ULL << 32U) - 2, (1ULL << 53U) - 2,
                                               (1ULL << 63U) - 2};

/// Which numbers became pairs, with jitter, losses and a stream that stalls.
std::vector<std::uint64_t> pairsFrom(Duration start, std::uint64_t first) {
    std::mt19937 random(3);
    devices::FramePool pool(devices::kFramesOnTheWay);
    devices::FrameSync sync({});
    std::vector<std::uint64_t> pairs;
    for (std::uint64_t i = 0; i < 2000; ++i) {
        const auto jitter = [&] { return Duration(random() % 8'000'000); };
        const TimePoint time(start + static_cast<Duration::rep>(i) * 33ms);
        if (random() % 10 != 0)
            sync.pushDepth(
                tinyFrame(pool, devices::PixelFormat::Depth16, time + jitter(), first + i), time);
        if (random() % 10 != 0 && i % 300 > 30)
            sync.pushColor(
                tinyFrame(pool, devices::PixelFormat::Rgba8, time + jitter(), first + i));
        while (const auto pair = sync.next(time)) {
            pairs.push_back(pair->depth.metadata().sequence - first);
            pairs.push_back(pair->color.metadata().sequence - first);
        }
    }
    return pairs;
}

TEST(LongLife, ThePairsAreThoseOfTheFirstDay) {
    const auto expected = pairsFrom(0s, 0);
    EXPECT_GT(expected.size(), 2000U);
    for (const std::uint64_t first : kCounts)
        EXPECT_EQ(pairsFrom(kTenYears, first), expected) << "frames from " << first;
}

TEST(LongLife, RecordingsKeepTheirPace) {
    FakeClock clock;
    clock.advance(kTenYears);
    devices::Input input;
    input.nominalPeriod = 33ms;
    input.depth =
        std::make_unique<FakeSource>(devices::PixelFormat::Depth16, regularTimes(50, 33ms));
    input = devices::paced(std::move(input), clock, false);
    const TimePoint start = clock.now();
    for (int i = 0; i < 50; ++i) {
        const auto result = input.depth->read(TimePoint::max());
        const auto* frame = std::get_if<devices::Frame>(&result);
        ASSERT_NE(frame, nullptr);
        EXPECT_EQ(frame->metadata().capturedAt - start, i * 33ms) << "to the nanosecond";
    }
}

TEST(LongLife, LiveIsLive) {
    const TimePoint start(kTenYears);
    daemon::ShowPolicy policy({}, start);
    devices::SensorStatus sensor{devices::SensorState::Streaming, start + 33ms, ""};
    for (int i = 0; i < 2; ++i) {
        ASSERT_TRUE(policy.arrived(start + i * 33ms, start + i * 33ms));
        policy.presented(start + i * 33ms);
    }
    const devices::SensorStatuses sensors{sensor, sensor};
    EXPECT_EQ(policy.decide(start + 233ms, sensors), daemon::Shown::Live);
    EXPECT_EQ(policy.decide(start + 233ms + 1ns, sensors), daemon::Shown::Frozen);
}

TEST(LongLife, FrameNumbersGoOn) {
    for (const std::uint64_t first : kCounts) {
        devices::SequenceCounter counter(first);
        std::uint32_t number = 0xfffffffeU; // the driver's own wraps meanwhile
        for (std::uint64_t i = 0; i < 5; ++i)
            EXPECT_EQ(counter.map(number++), first + i);
        EXPECT_EQ(counter.lost(), 0U);
    }
}

TEST(LongLife, TheReportCountsToTheLastFrame) {
    for (const std::uint64_t first : kCounts) {
        devices::FeedCounters before, now;
        before.pairs = before.depth.in = before.depth.paired = first;
        now.pairs = now.depth.in = now.depth.paired = 3;
        daemon::Report report;
        report.feed = devices::sum(before, now);
        report.presented = first + 3;
        report.skipped["unchanged"] = first;
        const auto json = nlohmann::json::parse(daemon::reportText(report));
        EXPECT_EQ(json.at("frames_in").get<std::uint64_t>(), first + 3);
        EXPECT_EQ(json.at("frames_presented").get<std::uint64_t>(), first + 3);
        EXPECT_EQ(json.at("streams").at("depth").at("in").get<std::uint64_t>(), first + 3);
        EXPECT_EQ(json.at("frames_skipped").get<std::uint64_t>(), first);
        EXPECT_NE(report.summary().find(std::to_string(first + 3)), std::string::npos);
    }
}

} // namespace
} // namespace autostereo::test
