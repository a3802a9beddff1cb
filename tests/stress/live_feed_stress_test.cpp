// Two sensors that deliver tiny frames as fast as they can, stall at random, lose their connection
// and come back; a consumer that stalls too. Every pair must be whole, in order and near in time,
// and the accounts must balance whenever they are looked at.
#include "devices/frame_pool.hpp"
#include "devices/live_feed.hpp"
#include "tests/stress/campaign.hpp"
#include "tests/support/fake_source.hpp"

#include <gtest/gtest.h>
#include <spdlog/spdlog.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <iostream>
#include <memory>
#include <random>
#include <thread>

using namespace autostereo;
using namespace autostereo::devices;
using namespace std::chrono_literals;

namespace {

constexpr Duration kPeriod = 33ms;

/// The sensor itself, which stays while its source is closed and opened again.
struct Sensor {
    PixelFormat format;
    std::uint64_t frames;
    std::mt19937 random;
    std::uint64_t next = 0;
    std::uint64_t delivered = 0;
    std::uint64_t starved = 0;
    std::uint64_t disconnects = 0;
    std::uint64_t opened = 0;
    const std::atomic<std::uint64_t>* partner = nullptr; ///< how far the other sensor is
    std::atomic<std::uint64_t> position{0};
};

/// Media time runs with the frames, so both sensors must keep roughly together, as real ones do.
class UnsteadySource final : public Source {
  public:
    explicit UnsteadySource(Sensor& sensor) : sensor_(sensor) { ++sensor_.opened; }

    ReadResult read(TimePoint) noexcept override {
        if (sensor_.next == sensor_.frames) return Ended{};
        const auto dice = static_cast<int>(sensor_.random() % 20'000);
        if (dice == 0) {
            ++sensor_.disconnects;
            return Disconnected{"by chance"};
        }
        if (dice < 20) std::this_thread::sleep_for(std::chrono::microseconds(dice * 10));
        if (sensor_.next > sensor_.partner->load(std::memory_order_relaxed) + 2) {
            std::this_thread::yield();
            return Timeout{};
        }
        const std::uint64_t number = sensor_.next++;
        sensor_.position.store(sensor_.next, std::memory_order_release);
        const Duration jitter = std::chrono::microseconds(sensor_.random() % 8000);
        const auto time = TimePoint(static_cast<Duration::rep>(number) * kPeriod + jitter);
        Frame frame = test::tinyFrame(pool_, sensor_.format, time, number);
        if (frame.empty()) {
            ++sensor_.starved;
            ++counters_.starved;
            return Timeout{};
        }
        ++sensor_.delivered;
        ++counters_.delivered;
        return frame;
    }
    bool rewind() noexcept override { return false; }
    SourceCounters counters() const noexcept override { return counters_; }

  private:
    Sensor& sensor_;
    FramePool pool_{kFramesOnTheWay};
    SourceCounters counters_;
};

void expectBalanced(const LiveFeed& feed, std::uint64_t given, const Sensor& depth,
                    const Sensor& color) {
    const auto position = [](const Sensor& sensor) {
        return sensor.position.load(std::memory_order_acquire);
    };
    const std::uint64_t depthBefore = position(depth);
    const std::uint64_t colorBefore = position(color);
    const FeedCounters counters = feed.counters();
    const auto check = [&](const StreamCounters& stream, std::uint64_t before,
                           std::uint64_t after) {
        ASSERT_EQ(stream.in, stream.paired + stream.unpaired);
        ASSERT_EQ(stream.paired, counters.pairs);
        // One frame may be on its way from the sensor into the queue.
        ASSERT_GE(stream.in + stream.pending + 1, before);
        ASSERT_LE(stream.in + stream.pending, after);
    };
    ASSERT_NO_FATAL_FAILURE(check(counters.depth, depthBefore, position(depth)));
    ASSERT_NO_FATAL_FAILURE(check(counters.color, colorBefore, position(color)));
    ASSERT_EQ(counters.pairs, given + counters.dropped);
}

/// What a consumer checks of every pair.
struct Consumer {
    std::uint64_t given = 0;
    std::int64_t lastIndex = -1;
    TimePoint lastTime = TimePoint::min();

    void look(const RgbdFrame& pair) {
        ++given;
        ASSERT_TRUE(test::isWhole(pair.depth));
        ASSERT_TRUE(test::isWhole(pair.color));
        ASSERT_GT(static_cast<std::int64_t>(pair.index), lastIndex);
        ASSERT_GT(pair.depth.metadata().capturedAt, lastTime);
        const Duration apart = pair.depth.metadata().capturedAt - pair.color.metadata().capturedAt;
        ASSERT_LE(std::chrono::abs(apart), SyncParams{}.tolerance);
        lastIndex = static_cast<std::int64_t>(pair.index);
        lastTime = pair.depth.metadata().capturedAt;
    }
};

void run(LiveFeed& feed, Consumer& consumer, std::optional<RgbdFrame>& held, const Sensor& depth,
         const Sensor& color) {
    std::mt19937 random(3);
    const auto limit = std::chrono::steady_clock::now() + 60s + depth.frames * 1ms;
    while (!feed.ended() && std::chrono::steady_clock::now() < limit) {
        if (auto pair = feed.next(20ms)) {
            ASSERT_NO_FATAL_FAILURE(consumer.look(*pair));
            held = std::move(pair); // as a renderer does while it draws
        }
        ASSERT_NO_FATAL_FAILURE(expectBalanced(feed, consumer.given, depth, color));
        if (random() % 1000 == 0) std::this_thread::sleep_for(2ms);
    }
    ASSERT_TRUE(feed.ended());
}

void expectAllAccountedFor(const StreamCounters& stream, const Sensor& sensor) {
    EXPECT_EQ(sensor.delivered + sensor.starved, sensor.frames);
    EXPECT_EQ(stream.in, sensor.frames);
    EXPECT_EQ(stream.pending, 0U);
    EXPECT_EQ(stream.reconnects, sensor.disconnects);
    EXPECT_EQ(sensor.opened, sensor.disconnects + 1);
}

TEST(LiveFeedStress, KeepsItsAccountsThroughStallsAndDisconnections) {
    spdlog::set_level(spdlog::level::off); // thousands of reconnections
    const std::uint64_t frames = test::campaign(200'000, 10'000'000);
    Sensor depth{.format = PixelFormat::Depth16, .frames = frames, .random = std::mt19937(1)};
    Sensor color{.format = PixelFormat::Rgba8, .frames = frames, .random = std::mt19937(2)};
    depth.partner = &color.position;
    color.partner = &depth.position;
    Input input;
    input.depth = std::make_unique<UnsteadySource>(depth);
    input.color = std::make_unique<UnsteadySource>(color);
    input.reopen = {[&] { return std::make_unique<UnsteadySource>(depth); },
                    [&] { return std::make_unique<UnsteadySource>(color); }};
    SteadyClock clock;
    std::optional<RgbdFrame> held; // outlives the feed
    Consumer consumer;
    {
        LiveFeed feed(std::move(input), clock, {}, {.firstDelay = 1ms, .longestDelay = 4ms});
        ASSERT_NO_FATAL_FAILURE(run(feed, consumer, held, depth, color));
        const FeedCounters counters = feed.counters();
        expectAllAccountedFor(counters.depth, depth);
        expectAllAccountedFor(counters.color, color);
        std::cout << frames << " frames a stream: " << counters.pairs << " pairs, "
                  << consumer.given << " given, " << counters.dropped << " dropped, "
                  << depth.disconnects + color.disconnects << " reconnects\n";
    }
    EXPECT_GT(consumer.given, frames / 100);
    ASSERT_TRUE(held);
    EXPECT_TRUE(test::isWhole(held->depth));
}

} // namespace
