#include "devices/source_thread.hpp"
#include "tests/support/fake_clock.hpp"
#include "tests/support/fake_source.hpp"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <stdexcept>
#include <string>
#include <vector>

#include <pthread.h>

using namespace autostereo;
using namespace autostereo::devices;
using namespace std::chrono_literals;

namespace {

/// A sensor that waits for ever, until its deadline each time.
class SilentSource final : public Source {
  public:
    SilentSource(Clock& clock, std::string& threadName) : clock_(clock), threadName_(threadName) {}
    ReadResult read(TimePoint deadline) noexcept override {
        std::array<char, 16> name{};
        pthread_getname_np(pthread_self(), name.data(), name.size());
        threadName_ = name.data();
        clock_.sleepUntil(deadline);
        return Timeout{};
    }
    bool rewind() noexcept override { return false; }
    SourceCounters counters() const noexcept override { return {}; }

  private:
    Clock& clock_;
    std::string& threadName_;
};

/// What every test needs around a thread; waiting is for the bell, with a generous limit.
struct Around {
    FrameQueue<Frame> queue;
    Doorbell bell;
    test::FakeClock clock;

    void waitForEnd(const SourceThread& thread) {
        const auto limit = std::chrono::steady_clock::now() + 10s;
        while (!thread.ended() && std::chrono::steady_clock::now() < limit)
            bell.wait(bell.count(), 10ms);
        ASSERT_TRUE(thread.ended());
    }
};

TEST(SourceThread, PushesUntilTheRecordingEnds) {
    Around around;
    SourceThread thread(
        "tof",
        std::make_unique<test::FakeSource>(PixelFormat::Depth16, test::regularTimes(3, 33ms)), {},
        around.queue, around.bell, around.clock, {});
    around.waitForEnd(thread);
    for (std::uint64_t i = 0; i < 3; ++i) {
        const auto frame = around.queue.take();
        ASSERT_TRUE(frame);
        EXPECT_EQ(frame->metadata().sequence, i);
        EXPECT_TRUE(test::isWhole(*frame));
    }
    EXPECT_FALSE(around.queue.take());
}

TEST(SourceThread, FramesOutliveTheThreadAndItsSource) {
    Around around;
    {
        SourceThread thread(
            "tof",
            std::make_unique<test::FakeSource>(PixelFormat::Depth16, test::regularTimes(2, 33ms)),
            {}, around.queue, around.bell, around.clock, {});
        around.waitForEnd(thread);
    }
    const auto frame = around.queue.take();
    ASSERT_TRUE(frame);
    EXPECT_TRUE(test::isWhole(*frame));
}

TEST(SourceThread, WithoutAWayToReopenALostSensorIsAnEnd) {
    Around around;
    SourceThread thread("tof",
                        std::make_unique<test::FakeSource>(PixelFormat::Depth16,
                                                           test::regularTimes(1, 33ms),
                                                           test::Then::Disconnects),
                        {}, around.queue, around.bell, around.clock, {});
    around.waitForEnd(thread);
    EXPECT_EQ(around.queue.pushed(), 1U);
    EXPECT_EQ(thread.counters().reconnects, 0U);
}

TEST(SourceThread, ReopensWithDelaysThatDoubleUpToTheLimit) {
    Around around;
    std::vector<TimePoint> attempts;
    const auto reopen = [&]() -> std::unique_ptr<Source> {
        attempts.push_back(around.clock.now());
        if (attempts.size() < 6) throw std::runtime_error("not there");
        return std::make_unique<test::FakeSource>(PixelFormat::Depth16,
                                                  test::regularTimes(2, 33ms, 500ms));
    };
    const TimePoint start = around.clock.now();
    SourceThread thread(
        "tof",
        std::make_unique<test::FakeSource>(PixelFormat::Depth16, test::regularTimes(1, 33ms),
                                           test::Then::Disconnects),
        reopen, around.queue, around.bell, around.clock, {.firstDelay = 200ms, .longestDelay = 1s});
    around.waitForEnd(thread);
    const std::vector<Duration> expected{200ms, 400ms, 800ms, 1000ms, 1000ms, 1000ms};
    ASSERT_EQ(attempts.size(), expected.size());
    TimePoint before = start;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(attempts[i] - before, expected[i]) << i;
        before = attempts[i];
    }
    EXPECT_EQ(thread.counters().reconnects, 1U);
    EXPECT_EQ(around.queue.pushed(), 3U);
}

TEST(SourceThread, ASensorThatComesAndGoesStartsWithTheFirstDelay) {
    Around around;
    std::vector<TimePoint> attempts;
    const auto reopen = [&]() -> std::unique_ptr<Source> {
        attempts.push_back(around.clock.now());
        const auto then = attempts.size() < 4 ? test::Then::Disconnects : test::Then::Ends;
        return std::make_unique<test::FakeSource>(PixelFormat::Depth16, test::regularTimes(1, 33ms),
                                                  then);
    };
    const TimePoint start = around.clock.now();
    SourceThread thread("tof",
                        std::make_unique<test::FakeSource>(PixelFormat::Depth16,
                                                           test::regularTimes(1, 33ms),
                                                           test::Then::Disconnects),
                        reopen, around.queue, around.bell, around.clock, {.firstDelay = 200ms});
    around.waitForEnd(thread);
    EXPECT_EQ(attempts.back() - start, 4 * 200ms);
    EXPECT_EQ(thread.counters().reconnects, 4U);
}

TEST(SourceThread, IsNamedAndStopsPromptly) {
    SteadyClock clock;
    FrameQueue<Frame> queue;
    Doorbell bell;
    std::string name;
    const auto begin = clock.now();
    {
        const SourceThread thread("color", std::make_unique<SilentSource>(clock, name), {}, queue,
                                  bell, clock, {});
        clock.sleepUntil(clock.now() + 5ms);
    }
    EXPECT_EQ(name, "color");
    EXPECT_LT(clock.now() - begin, 1s); // one read slice, and room for a loaded machine
}

TEST(SourceThread, StopsPromptlyWhileItWaitsForASensor) {
    SteadyClock clock;
    FrameQueue<Frame> queue;
    Doorbell bell;
    const auto begin = clock.now();
    {
        const SourceThread thread(
            "color",
            std::make_unique<test::FakeSource>(PixelFormat::Rgba8, test::regularTimes(0, 33ms),
                                               test::Then::Disconnects),
            []() -> std::unique_ptr<Source> { throw std::runtime_error("not there"); }, queue, bell,
            clock, {.firstDelay = 60s, .longestDelay = 60s});
        clock.sleepUntil(clock.now() + 5ms);
    }
    EXPECT_LT(clock.now() - begin, 1s);
}

} // namespace
