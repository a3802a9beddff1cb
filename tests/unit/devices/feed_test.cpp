#include "devices/live_feed.hpp"
#include "devices/paced_source.hpp"
#include "devices/replay_feed.hpp"
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
    input.nominalPeriod = 33ms;
    input.depth = std::make_unique<test::FakeSource>(PixelFormat::Depth16, std::move(depths));
    input.color = std::make_unique<test::FakeSource>(PixelFormat::Rgba8, std::move(colors));
    return input;
}

void expectBalanced(const FeedCounters& counters) {
    for (const StreamCounters& stream : {counters.depth, counters.color}) {
        EXPECT_EQ(stream.in, stream.paired + stream.unpaired);
        EXPECT_EQ(stream.paired, counters.pairs);
    }
}

TEST(ReplayFeed, GivesEveryPairInOrderAndThenEnds) {
    ReplayFeed feed(recording(test::regularTimes(100, 33ms), test::regularTimes(100, 33ms, 4ms)),
                    {}, false);
    std::uint64_t pairs = 0;
    while (!feed.ended()) {
        const auto pair = feed.next(0ms);
        expectBalanced(feed.counters());
        if (!pair) continue;
        EXPECT_EQ(pair->index, pairs);
        EXPECT_EQ(pair->depth.metadata().sequence, pairs);
        EXPECT_EQ(pair->color.metadata().sequence, pairs);
        EXPECT_TRUE(test::isWhole(pair->depth) && test::isWhole(pair->color));
        ++pairs;
    }
    const FeedCounters counters = feed.counters();
    EXPECT_EQ(pairs, 100U);
    EXPECT_EQ(counters.pairs, 100U);
    EXPECT_EQ(counters.dropped, 0U);
    EXPECT_EQ(counters.depth.in, 100U);
    EXPECT_EQ(counters.depth.pending + counters.color.pending, 0U);
    EXPECT_FALSE(feed.next(0ms));
}

TEST(ReplayFeed, ALoopGoesOnWithRisingTimeAndSequence) {
    ReplayFeed feed(recording(test::regularTimes(3, 33ms), test::regularTimes(3, 33ms)), {}, true);
    for (int i = 0; i < 10; ++i) {
        const auto pair = feed.next(0ms);
        ASSERT_TRUE(pair) << i;
        EXPECT_EQ(pair->depth.metadata().capturedAt.time_since_epoch(), i * 33ms);
        EXPECT_EQ(pair->color.metadata().sequence, static_cast<std::uint64_t>(i));
    }
    EXPECT_FALSE(feed.ended());
}

TEST(ReplayFeed, ALoopOverNothingEnds) {
    ReplayFeed feed(recording({}, test::regularTimes(3, 33ms)), {}, true);
    for (int i = 0; i < 10 && !feed.ended(); ++i)
        EXPECT_FALSE(feed.next(0ms));
    EXPECT_TRUE(feed.ended());
    EXPECT_EQ(feed.counters().color.unpaired, 3U);
}

TEST(ReplayFeed, NeverHoldsItsConsumerForARecordingWithoutPairs) {
    ReplayFeed feed(
        recording(test::regularTimes(1000, 33ms), test::regularTimes(1000, 33ms, 3600s)), {},
        false);
    int calls = 0;
    for (; !feed.ended() && calls < 1000; ++calls)
        EXPECT_FALSE(feed.next(0ms));
    EXPECT_GT(calls, 10);
    EXPECT_TRUE(feed.ended());
    EXPECT_EQ(feed.counters().depth.unpaired, 1000U);
}

TEST(LiveFeed, PairsPacedStreamsAndEnds) {
    test::FakeClock clock;
    LiveFeed feed(
        paced(recording(test::regularTimes(20, 33ms), test::regularTimes(20, 33ms)), clock, false),
        clock, {}, {});
    const auto limit = std::chrono::steady_clock::now() + 10s;
    std::uint64_t given = 0;
    while (!feed.ended() && std::chrono::steady_clock::now() < limit) {
        if (const auto pair = feed.next(1ms)) {
            ++given;
            EXPECT_EQ(pair->depth.metadata().capturedAt, pair->color.metadata().capturedAt);
            EXPECT_TRUE(test::isWhole(pair->depth) && test::isWhole(pair->color));
        }
        expectBalanced(feed.counters());
    }
    const FeedCounters counters = feed.counters();
    ASSERT_TRUE(feed.ended());
    EXPECT_EQ(counters.pairs, given + counters.dropped);
    for (const StreamCounters& stream : {counters.depth, counters.color}) {
        EXPECT_EQ(stream.in, 20U);
        EXPECT_EQ(stream.pending, 0U);
    }
}

TEST(LiveFeed, AConsumerThatWasAwayGetsTheNewestPair) {
    test::FakeClock clock;
    LiveFeed feed(recording(test::regularTimes(4, 33ms), test::regularTimes(4, 33ms)), clock, {},
                  {});
    const auto limit = std::chrono::steady_clock::now() + 10s;
    while (feed.counters().depth.pending < 4 || feed.counters().color.pending < 4)
        ASSERT_LT(std::chrono::steady_clock::now(), limit);
    const auto pair = feed.next(0ms);
    ASSERT_TRUE(pair);
    EXPECT_EQ(pair->depth.metadata().sequence, 3U);
    EXPECT_EQ(pair->index, 3U);
    EXPECT_EQ(feed.counters().dropped, 3U);
}

TEST(LiveFeed, NextReturnsWhenItsTimeIsOver) {
    SteadyClock clock;
    Input silent = recording(test::regularTimes(2, 3600s), test::regularTimes(2, 3600s, 10s));
    LiveFeed feed(paced(std::move(silent), clock, false), clock, {}, {});
    const TimePoint begin = clock.now();
    EXPECT_FALSE(feed.next(20ms));
    EXPECT_GE(clock.now() - begin, 20ms);
    EXPECT_LT(clock.now() - begin, 1s); // room for a loaded machine
    EXPECT_FALSE(feed.ended());
}

} // namespace
