#include "calib/counter_chart.hpp"
#include "calib/solve/counter_reader.hpp"
#include "devices/panel_delay.hpp"
#include "devices/replay/grey_image.hpp"
#include "devices/sim/panel_watcher.hpp"
#include "tests/support/fake_clock.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <cstdlib>
#include <string>

using namespace autostereo;
using namespace std::chrono_literals;
using calib::CounterChart;
using calibrate::CounterReader;

namespace {

constexpr devices::Duration kRefresh = 16'666'667ns;

calibrate::GreyImage imageOf(const devices::GreyPixels& grey) {
    return {grey.width, grey.height, grey.values, false};
}

TEST(CounterChart, NeighboursDifferInOneBitAndEveryNumberComesBack) {
    for (unsigned number = 0; number < CounterChart::kNumbers; ++number) {
        const unsigned gray = CounterChart::grayOf(number);
        EXPECT_EQ(CounterChart::numberOf(gray), number);
        const unsigned next = CounterChart::grayOf((number + 1) % CounterChart::kNumbers);
        EXPECT_EQ(std::popcount(gray ^ next), 1) << number;
    }
}

/// A panel on a made-up clock and the camera in front of it.
class Watched {
  public:
    explicit Watched(const devices::sim::WatchedPanel& panel) : watcher_(panel, clock) {}

    /// At the next refresh.
    devices::TimePoint swap(const calib::Picture& picture) {
        const auto ticks = clock.now().time_since_epoch() / kRefresh + 1;
        clock.sleepUntil(devices::TimePoint(ticks * kRefresh));
        return watcher_.shown(picture);
    }
    /// The pictures that are ready at this time.
    std::vector<devices::Frame> arrived() {
        std::vector<devices::Frame> frames;
        for (;;) {
            auto result = watcher_.read(clock.now());
            if (auto* frame = std::get_if<devices::Frame>(&result))
                frames.push_back(std::move(*frame));
            else
                return frames;
        }
    }
    /// After the board was looked at.
    std::optional<CounterReader> find() {
        (void)swap(CounterChart::board());
        clock.advance(200ms);
        const auto frames = arrived();
        return CounterReader::find(imageOf(devices::greyOf(frames.back())));
    }

    test::FakeClock clock;

  private:
    devices::sim::PanelWatcher watcher_;
};

TEST(CounterReader, ReadsEveryNumberAskewBlurredAndWithNoise) {
    Watched watched({});
    const auto reader = watched.find();
    ASSERT_TRUE(reader);
    for (unsigned number = 0; number < CounterChart::kNumbers; ++number) {
        (void)watched.swap(CounterChart::blocks(number));
        watched.clock.advance(100ms);
        const auto frames = watched.arrived();
        ASSERT_FALSE(frames.empty());
        const auto read = reader->read(imageOf(devices::greyOf(frames.back())));
        ASSERT_TRUE(std::holds_alternative<unsigned>(read)) << number;
        EXPECT_EQ(std::get<unsigned>(read), number);
    }
}

TEST(CounterReader, WhatItCannotReadItRefuses) {
    Watched watched({});
    EXPECT_FALSE(CounterReader::find(
        imageOf(devices::GreyPixels{64, 48, std::vector<std::uint16_t>(64 * 48, 90), false})));
    const auto reader = watched.find();
    ASSERT_TRUE(reader);
    const auto doubtOf = [&](const calibrate::GreyImage& image) {
        const auto read = reader->read(image);
        const auto* doubt = std::get_if<CounterReader::Doubt>(&read);
        return doubt == nullptr ? std::nullopt : std::optional(*doubt);
    };
    const std::vector<std::uint16_t> even(std::size_t{320} * 240, 90);
    EXPECT_EQ(doubtOf({320, 240, even, false}), CounterReader::Doubt::Unseen);
    EXPECT_EQ(doubtOf({160, 480, even, false}), CounterReader::Doubt::Unseen);

    const auto shot = [&](unsigned number) {
        (void)watched.swap(CounterChart::blocks(number));
        watched.clock.advance(100ms);
        return devices::greyOf(watched.arrived().back());
    };
    devices::GreyPixels mixed = shot(21);
    const devices::GreyPixels next = shot(22);
    for (std::size_t i = 0; i < mixed.values.size(); ++i)
        mixed.values[i] = static_cast<std::uint16_t>((mixed.values[i] + next.values[i]) / 2);
    EXPECT_EQ(doubtOf(imageOf(mixed)), CounterReader::Doubt::Changing);
}

struct Truth {
    const char* name;
    devices::sim::WatchedPanel panel;
};

class PanelDelayOf : public testing::TestWithParam<Truth> {};

TEST_P(PanelDelayOf, AKnownPanelIsFound) {
    const devices::sim::WatchedPanel& truth = GetParam().panel;
    Watched watched(truth);
    const auto reader = watched.find();
    ASSERT_TRUE(reader);
    std::vector<devices::TimePoint> swaps;
    std::vector<devices::SeenNumber> seen;
    std::size_t doubtful = 0;
    for (unsigned number = 0; number < 400; ++number) {
        swaps.push_back(watched.swap(CounterChart::blocks(number)));
        for (int step = 0; step < 45 + static_cast<int>(number * 7 % 40); ++step) {
            watched.clock.advance(1ms);
            for (const devices::Frame& frame : watched.arrived()) {
                const auto read = reader->read(imageOf(devices::greyOf(frame)));
                if (const auto* value = std::get_if<unsigned>(&read))
                    seen.push_back({*value, frame.metadata().capturedAt, watched.clock.now()});
                else
                    ++doubtful;
            }
        }
    }
    const devices::PanelDelay found = devices::panelDelay(swaps, seen);
    ASSERT_GT(found.toLight.size(), 300U);
    EXPECT_LE(found.unmatched, 6U); // of the board, and of the last number
    EXPECT_GT(doubtful, 0U);        // every exposure that a change falls into the middle of
    EXPECT_LE(found.least, truth.delay);
    EXPECT_GE(found.most, truth.delay);
    // Where camera and panel keep in step, readings fall at the same phases of a refresh; and the
    // exposure has to lie within a number's time, or most of it.
    EXPECT_LE(found.most - found.least, kRefresh + truth.exposure);
    auto sorted = found.toLight;
    std::ranges::sort(sorted);
    EXPECT_LE(std::chrono::abs(sorted[sorted.size() / 2] - truth.delay), kRefresh / 2); // as above
    for (const auto delay : found.toLight)
        EXPECT_LE(std::chrono::abs(delay - truth.delay), found.longestStood / 2);
    // On the way: the exposure's other half, the transfer, and our steps of 1 ms.
    for (std::size_t i = 0; i < found.toLight.size(); ++i) {
        const auto way =
            found.toArrival[i] - found.toLight[i] - truth.exposure / 2 - truth.transfer;
        EXPECT_GE(way, 0ms);
        EXPECT_LE(way, kRefresh + 1ms);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Panels, PanelDelayOf,
    testing::Values(Truth{"Quick", {.delay = 3ms, .exposure = 2ms}}, Truth{"Usual", {}},
                    Truth{"SlowDimAndDark", {.delay = 87ms, .exposure = 30ms, .transfer = 40ms}},
                    Truth{"At25", {.delay = 41ms, .fps = 25, .seed = 9}}),
    [](const auto& truth) { return std::string(truth.param.name); });

TEST(PanelDelay, AReadingThatFitsNoSwapIsCounted) {
    const std::vector<devices::TimePoint> swaps{devices::TimePoint(0s), devices::TimePoint(50ms),
                                                devices::TimePoint(100ms)};
    const auto seen = [](unsigned number, devices::Duration at) {
        return devices::SeenNumber{number, devices::TimePoint(at), devices::TimePoint(at)};
    };
    const std::vector<devices::SeenNumber> readings{seen(0, 60ms), seen(1, 40ms), seen(1, 2s),
                                                    seen(2, 130ms), seen(900, 60ms)};
    const devices::PanelDelay delay = devices::panelDelay(swaps, readings);
    EXPECT_EQ(delay.unmatched, 4U); // before its swap, too late, not known how long, never shown
    ASSERT_EQ(delay.toLight.size(), 1U);
    EXPECT_EQ(delay.toLight[0], 35ms);
    EXPECT_EQ(delay.least, 10ms);
    EXPECT_EQ(delay.most, 60ms);
}

} // namespace
