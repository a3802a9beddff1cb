#include "devices/paced_source.hpp"
#include "tests/support/fake_clock.hpp"
#include "tests/support/fake_source.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <vector>

using namespace autostereo;
using namespace autostereo::devices;
using namespace std::chrono_literals;

namespace {

Input recording(std::vector<Duration> depths, std::vector<Duration> colors) {
    Input input;
    input.startsAt = std::min(depths.front(), colors.front());
    input.nominalPeriod = 33ms;
    input.depth = std::make_unique<test::FakeSource>(PixelFormat::Depth16, std::move(depths));
    input.color = std::make_unique<test::FakeSource>(PixelFormat::Rgba8, std::move(colors));
    return input;
}

/// Reads with the deadlines of a source thread until something other than Timeout comes.
ReadResult patientRead(Source& source, const Clock& clock) {
    for (int attempt = 0; attempt < 1000; ++attempt) {
        ReadResult result = source.read(clock.now() + 50ms);
        if (!std::holds_alternative<Timeout>(result)) return result;
    }
    return Timeout{};
}

TEST(PacedSource, ReleasesFramesAtTheirTimeAndStampsThem) {
    test::FakeClock clock;
    const Input input = paced(recording({1000ms, 1033ms, 1300ms}, {1010ms}), clock, false);
    const TimePoint start = clock.now();
    for (const Duration expected : {0ms, 33ms, 300ms}) {
        const ReadResult result = patientRead(*input.depth, clock);
        const auto* frame = std::get_if<Frame>(&result);
        ASSERT_NE(frame, nullptr);
        EXPECT_EQ(frame->metadata().capturedAt - start, expected);
        EXPECT_EQ(clock.now() - start, expected);
    }
    EXPECT_TRUE(std::holds_alternative<Ended>(patientRead(*input.depth, clock)));
}

TEST(PacedSource, BothStreamsShareOneStart) {
    test::FakeClock clock;
    const Input input = paced(recording({1000ms}, {1010ms}), clock, false);
    const TimePoint start = clock.now();
    const ReadResult depth = patientRead(*input.depth, clock);
    clock.advance(5ms);
    const ReadResult color = patientRead(*input.color, clock);
    EXPECT_EQ(std::get<Frame>(depth).metadata().capturedAt, start);
    EXPECT_EQ(std::get<Frame>(color).metadata().capturedAt, start + 10ms);
}

TEST(PacedSource, KeepsTheDeadlineAndTheFrame) {
    test::FakeClock clock;
    const Input input = paced(recording({0ms, 100ms}, {0ms}), clock, false);
    ASSERT_TRUE(std::holds_alternative<Frame>(input.depth->read(clock.now() + 50ms)));
    const TimePoint before = clock.now();
    EXPECT_TRUE(std::holds_alternative<Timeout>(input.depth->read(before + 50ms)));
    EXPECT_EQ(clock.now(), before + 50ms);
    EXPECT_TRUE(std::holds_alternative<Frame>(input.depth->read(before + 150ms)));
    EXPECT_EQ(clock.now(), before + 100ms);
}

TEST(PacedSource, ALateReaderGetsEveryFrameAtOnce) {
    test::FakeClock clock;
    const Input input = paced(recording(test::regularTimes(10, 33ms), {0ms}), clock, false);
    ASSERT_TRUE(std::holds_alternative<Frame>(patientRead(*input.depth, clock)));
    clock.advance(5s);
    const TimePoint late = clock.now();
    for (std::uint64_t i = 1; i < 10; ++i) {
        const ReadResult result = input.depth->read(clock.now() + 50ms);
        ASSERT_TRUE(std::holds_alternative<Frame>(result));
        EXPECT_EQ(std::get<Frame>(result).metadata().sequence, i);
    }
    EXPECT_EQ(clock.now(), late);
}

TEST(PacedSource, LoopsBothStreamsTogetherWithRisingTime) {
    test::FakeClock clock;
    // Depth ends 66 ms before colour does; the next round waits for colour.
    const Input input = paced(recording({0ms, 33ms}, {0ms, 33ms, 99ms}), clock, true);
    const TimePoint start = clock.now();
    const auto timeOfNext = [&](Source& source, std::uint64_t sequence) {
        const ReadResult result = patientRead(source, clock);
        const auto* frame = std::get_if<Frame>(&result);
        EXPECT_NE(frame, nullptr);
        if (frame == nullptr) return Duration{-1};
        EXPECT_EQ(frame->metadata().sequence, sequence);
        return frame->metadata().capturedAt - start;
    };
    EXPECT_EQ(timeOfNext(*input.depth, 0), 0ms);
    EXPECT_EQ(timeOfNext(*input.color, 0), 0ms);
    EXPECT_EQ(timeOfNext(*input.depth, 1), 33ms);
    EXPECT_EQ(timeOfNext(*input.color, 1), 33ms);
    EXPECT_TRUE(std::holds_alternative<Timeout>(input.depth->read(clock.now() + 5ms)));
    EXPECT_EQ(timeOfNext(*input.color, 2), 99ms);
    EXPECT_TRUE(std::holds_alternative<Timeout>(input.color->read(clock.now() + 1ms)));
    EXPECT_EQ(timeOfNext(*input.depth, 2), 99ms + 33ms);
    EXPECT_EQ(timeOfNext(*input.color, 3), 99ms + 33ms);
    EXPECT_EQ(timeOfNext(*input.depth, 3), 99ms + 33ms + 33ms);
}

TEST(PacedSource, ADamagedTimeStopsTheStreamForTenSecondsAtMost) {
    test::FakeClock clock;
    const Input input = paced(recording({0ms, Duration::max(), 66ms}, {0ms}), clock, false);
    ASSERT_TRUE(std::holds_alternative<Frame>(patientRead(*input.depth, clock)));
    const TimePoint before = clock.now();
    ASSERT_TRUE(std::holds_alternative<Frame>(patientRead(*input.depth, clock)));
    EXPECT_EQ(clock.now() - before, 10s);
    ASSERT_TRUE(std::holds_alternative<Frame>(patientRead(*input.depth, clock)));
    EXPECT_EQ(clock.now() - before, 10s);
}

} // namespace
