// The time stamps of a real pair of cameras: 30 Hz each, with jitter and lost frames.
#include "devices/frame_sync.hpp"
#include "tests/support/data.hpp"
#include "tests/support/fake_source.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace autostereo;
using namespace autostereo::devices;
using namespace std::chrono_literals;

namespace {

constexpr Duration kTolerance = 20ms;
using Times = std::vector<Duration>;
using Pairs = std::vector<std::pair<Duration, Duration>>;

Times readTimes(const std::string& name, std::size_t step) {
    std::ifstream file(test::dataDir() / "tum-fr1-rpy" / name);
    Times times;
    std::size_t row = 0;
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line[0] == '#' || row++ % step != 0) continue;
        times.emplace_back(std::llround(std::stod(line) * 1e6) * 1000);
    }
    return times;
}

/// The definition, by looking at all frames: nearest colour not used and not passed over yet.
Pairs nearestPairs(const Times& depths, const Times& colors) {
    Pairs pairs;
    std::size_t free = 0;
    for (const Duration depth : depths) {
        std::size_t best = colors.size();
        Duration least = kTolerance + 1ns;
        for (std::size_t i = free; i < colors.size(); ++i) {
            const Duration distance = std::chrono::abs(colors[i] - depth);
            if (distance >= least) continue;
            best = i;
            least = distance;
        }
        if (best == colors.size()) continue;
        pairs.emplace_back(depth, colors[best]);
        free = best + 1;
    }
    return pairs;
}

/// Frames arrive in the order of their times, colour `colorDelay` later than it was taken.
Pairs syncedPairs(const Times& depths, const Times& colors, Duration colorDelay) {
    FramePool pool(kFramesOnTheWay);
    FrameSync sync(SyncParams{.tolerance = kTolerance});
    Pairs pairs;
    const auto collect = [&] {
        while (const auto pair = sync.next())
            pairs.emplace_back(pair->depth.metadata().capturedAt.time_since_epoch(),
                               pair->color.metadata().capturedAt.time_since_epoch());
    };
    for (std::size_t d = 0, c = 0; d < depths.size() || c < colors.size();) {
        const bool depthNext =
            c == colors.size() || (d < depths.size() && depths[d] < colors[c] + colorDelay);
        if (depthNext)
            sync.pushDepth(test::tinyFrame(pool, PixelFormat::Depth16, TimePoint(depths[d++])));
        else
            sync.pushColor(test::tinyFrame(pool, PixelFormat::Rgba8, TimePoint(colors[c++])));
        collect();
    }
    sync.flush();
    collect();
    const FeedCounters counters = sync.counters();
    EXPECT_EQ(counters.depth.in, depths.size());
    EXPECT_EQ(counters.color.in, colors.size());
    return pairs;
}

struct Rates {
    const char* name;
    std::size_t depthStep;
    std::size_t colorStep;
    std::size_t leastPairs;
};

class FrameSyncJitter : public testing::TestWithParam<Rates> {};

TEST_P(FrameSyncJitter, FindsTheNearestPairsWhicheverCameraIsLate) {
    AUTOSTEREO_NEED_DATA("tum-fr1-rpy/depth.txt");
    const Times depths = readTimes("depth.txt", GetParam().depthStep);
    const Times colors = readTimes("rgb.txt", GetParam().colorStep);
    const Pairs expected = nearestPairs(depths, colors);
    EXPECT_GE(expected.size(), GetParam().leastPairs);
    for (const Duration delay : {-60ms, -10ms, 0ms, 10ms, 60ms})
        EXPECT_TRUE(syncedPairs(depths, colors, delay) == expected)
            << "colour late by " << delay.count() << " ns";
}

// 722 depth and 723 colour frames; the least numbers are 95 % of what the rates allow.
INSTANTIATE_TEST_SUITE_P(RealLists, FrameSyncJitter,
                         testing::Values(Rates{"Both30", 1, 1, 686},
                                         Rates{"Depth30Color15", 1, 2, 343},
                                         Rates{"Depth15Color30", 2, 1, 343}),
                         [](const auto& rates) { return std::string(rates.param.name); });

} // namespace
