#include "devices/frame_sync.hpp"
#include "tests/support/fake_source.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <sstream>
#include <string>
#include <utility>

using namespace autostereo;
using namespace autostereo::devices;
using namespace std::chrono_literals;

namespace {

TimePoint at(std::chrono::milliseconds time) { return TimePoint(time); }

/// Frames go in by name ("d33": depth at 33 ms), pairs come out as "33-35" (depth-colour).
class SyncRig {
  public:
    void arrive(const std::string& frame, TimePoint now = {}) {
        const TimePoint time(std::chrono::milliseconds(std::stol(frame.substr(1))));
        push(frame[0] == 'd', time, now);
    }
    void push(bool depth, TimePoint time, TimePoint now = {}) {
        const auto format = depth ? PixelFormat::Depth16 : PixelFormat::Rgba8;
        Frame frame = test::tinyFrame(pool_, format, time);
        ASSERT_FALSE(frame.empty()) << "more frames are kept than the pool holds";
        if (depth)
            sync.pushDepth(std::move(frame), now);
        else
            sync.pushColor(std::move(frame));
        ++(depth ? depthsPushed_ : colorsPushed_);
    }
    void note(const std::optional<RgbdFrame>& pair) {
        const auto ms = [](const Frame& frame) {
            const auto time = frame.metadata().capturedAt.time_since_epoch();
            return std::to_string(
                std::chrono::duration_cast<std::chrono::milliseconds>(time).count());
        };
        pairs += (pairs.empty() ? "" : " ") + ms(pair->depth) + "-" + ms(pair->color);
    }
    void collect() {
        while (const auto pair = sync.next())
            note(pair);
    }
    void collect(TimePoint now) {
        while (const auto pair = sync.next(now))
            note(pair);
    }
    void expectBalanced() const {
        const FeedCounters counters = sync.counters();
        const auto check = [&](const StreamCounters& stream, std::uint64_t pushed) {
            EXPECT_EQ(stream.in, stream.paired + stream.unpaired);
            EXPECT_EQ(stream.in + stream.pending, pushed);
            EXPECT_EQ(stream.paired, counters.pairs);
        };
        check(counters.depth, depthsPushed_);
        check(counters.color, colorsPushed_);
    }

  private:
    FramePool pool_{kFramesOnTheWay};
    std::uint64_t depthsPushed_ = 0;
    std::uint64_t colorsPushed_ = 0;

  public:
    FrameSync sync{SyncParams{.tolerance = 20ms}};
    std::string pairs;
};

struct Row {
    const char* name;
    const char* arrivals;
    const char* pairs;
};

class FrameSyncTable : public testing::TestWithParam<Row> {};

TEST_P(FrameSyncTable, PairsComeOut) {
    SyncRig rig;
    std::istringstream arrivals(GetParam().arrivals);
    for (std::string frame; arrivals >> frame;) {
        rig.arrive(frame);
        rig.collect();
        rig.expectBalanced();
    }
    rig.sync.flush();
    rig.collect();
    rig.expectBalanced();
    EXPECT_EQ(rig.pairs, GetParam().pairs);
    EXPECT_EQ(rig.sync.counters().depth.pending, 0U);
    EXPECT_EQ(rig.sync.counters().color.pending, 0U);
}

INSTANTIATE_TEST_SUITE_P(
    Times, FrameSyncTable,
    testing::Values(
        Row{"InStep", "c0 d0 c33 d33 c67 d67", "0-0 33-33 67-67"},
        Row{"DepthFirst", "d0 c2 d33 c35 d67 c69", "0-2 33-35 67-69"},
        Row{"ColorLateByTwoFrames", "d0 d33 c0 d67 c33 d100 c67 c100", "0-0 33-33 67-67 100-100"},
        Row{"DepthLateByThreeFrames", "c0 c33 c67 d0 c100 d33 c133 d67", "0-0 33-33 67-67"},
        Row{"LaterIsNearer", "c0 d12 c20", "12-20"}, Row{"EarlierIsNearer", "c0 d8 c20", "8-0"},
        Row{"EquallyFarTakesTheEarlier", "c0 d10 c20", "10-0"},
        Row{"JustWithinTolerance", "c0 d20 c60", "20-0"}, Row{"OutsideTolerance", "c0 d21 c42", ""},
        Row{"EachColorOnce", "c10 d5 d15 c40", "5-10"},
        Row{"Depth30Color15", "d0 c0 d33 d67 c67 d100 d133 c133", "0-0 67-67 133-133"},
        Row{"Depth15Color30", "c0 d0 c33 c67 d67 c100 c133 d133", "0-0 67-67 133-133"},
        Row{"Depth30Color15OutOfPhase", "d0 c10 d33 d67 c77 d100 d133 c143", "0-10 67-77 133-143"},
        Row{"LostColor", "c0 d0 d33 c67 d67", "0-0 67-67"},
        Row{"LostDepth", "c0 d0 c33 c67 d67", "0-0 67-67"},
        Row{"ColorStallsAndComesBack", "c0 d0 d33 d67 d100 d133 c133 d167 c167",
            "0-0 133-133 167-167"},
        Row{"DepthStallsAndComesBack", "c0 d0 c33 c67 c100 c133 c167 d167", "0-0 167-167"},
        Row{"Duplicates", "c0 d0 c0 d0 c33 c33 d33 d33", "0-0 33-33"},
        Row{"BothStepBack", "c1000 d1000 c0 d0 c33 d33", "1000-1000 0-0 33-33"},
        Row{"BothStepBackDepthFirst", "c1000 d1000 d0 d33 c0 c33 d67 c67", "1000-1000 67-67"},
        Row{"DepthAloneStepsBack", "c1000 d1000 d0 c1033 d1033", "1000-1000 1033-1033"},
        Row{"DepthLeapsAheadAndBack", "c0 d0 d999999 c33 d33 c67 d67", "0-0 33-33 67-67"},
        Row{"ColorLeapsAheadAndBack", "c0 d0 c999999 d33 c67 d67 c100 d100", "0-0 67-67 100-100"},
        Row{"NoColor", "d0 d33 d67 d100 d133", ""}, Row{"NoDepth", "c0 c33 c67 c100 c133", ""}),
    [](const auto& row) { return std::string(row.param.name); });

/// Colour c0 is used and c33 (or, in a later test, none) is what depth d45 has so far.
void depth45Waits(SyncRig& rig, TimePoint now) {
    for (const char* frame : {"c0", "d12", "c33"})
        rig.arrive(frame, now);
    rig.collect(now);
    rig.arrive("d45", now);
    rig.collect(now);
    ASSERT_EQ(rig.pairs, "12-0");
}

TEST(FrameSyncGrace, ADoubtfulPartnerWaitsHalfAPeriod) {
    SyncRig rig;
    const TimePoint now = at(5000ms);
    depth45Waits(rig, now);
    ASSERT_EQ(rig.sync.ripeAt(), now + 16500us); // half the depth period
    rig.collect(*rig.sync.ripeAt() - 1ns);
    EXPECT_EQ(rig.pairs, "12-0");
    rig.collect(*rig.sync.ripeAt());
    EXPECT_EQ(rig.pairs, "12-0 45-33");
}

TEST(FrameSyncGrace, ANearerColorThatComesInTimeIsTaken) {
    SyncRig rig;
    const TimePoint now = at(5000ms);
    depth45Waits(rig, now);
    rig.arrive("c50");
    rig.collect(now + 5ms);
    EXPECT_EQ(rig.pairs, "12-0 45-50");
}

TEST(FrameSyncGrace, AGoodPartnerIsTakenAtOnce) {
    SyncRig rig;
    const TimePoint now = at(5000ms);
    for (const char* frame : {"c0", "d2", "c33", "d35"})
        rig.arrive(frame, now);
    rig.collect(now);
    EXPECT_EQ(rig.pairs, "2-0 35-33"); // the next colour, at 66 or so, cannot be nearer
}

TEST(FrameSyncGrace, ALostFrameMakesNobodyWaitLonger) {
    SyncRig rig;
    const TimePoint now = at(5000ms);
    depth45Waits(rig, now);
    for (const char* frame : {"c66", "c100", "d112"}) // d78 is lost
        rig.arrive(frame, now);
    rig.collect(now);
    ASSERT_EQ(rig.pairs, "12-0 45-33");
    EXPECT_EQ(rig.sync.ripeAt(), now + 16500us); // half of 33 ms, not of 67
}

TEST(FrameSyncGrace, ALostColorHidesNoNearerOne) {
    SyncRig rig;
    const TimePoint now = at(5000ms);
    for (const char* frame : {"c0", "d12", "c33", "d45", "c100", "d112"}) // c67 and d78 are lost
        rig.arrive(frame, now);
    rig.collect(now);
    ASSERT_EQ(rig.pairs, "12-0 45-33");
    EXPECT_EQ(rig.sync.ripeAt(), now + 16500us); // colour 133 could be nearer than 12 ms by jitter
}

TEST(FrameSyncGrace, WithoutAPartnerThereIsNothingToWakeFor) {
    SyncRig rig;
    rig.arrive("d0", at(5000ms));
    rig.collect(at(60'000ms));
    EXPECT_EQ(rig.pairs, "");
    EXPECT_FALSE(rig.sync.ripeAt());
    rig.arrive("c1");
    rig.collect();
    EXPECT_EQ(rig.pairs, "0-1");
}

TEST(FrameSync, ALateClockIsPutRight) {
    FramePool pool(4);
    FrameSync sync({.tolerance = 5ms, .colorLate = 12ms});
    sync.pushDepth(test::tinyFrame(pool, PixelFormat::Depth16, at(100ms)));
    sync.pushColor(test::tinyFrame(pool, PixelFormat::Rgba8, at(113ms)));
    sync.flush();
    const auto pair = sync.next();
    ASSERT_TRUE(pair);
    EXPECT_EQ(pair->color.metadata().capturedAt, at(101ms));
}

TEST(FrameSync, AStepBackDelaysNothing) {
    SyncRig rig;
    for (const char* frame : {"c0", "d0", "d999999", "c33", "d33"}) {
        rig.arrive(frame);
        rig.collect();
    }
    EXPECT_EQ(rig.pairs, "0-0 33-33"); // the frame from far ahead is no longer waited for
}

TEST(FrameSync, SurvivesTheExtremesOfTime) {
    SyncRig rig;
    for (int round = 0; round < 3; ++round)
        for (const TimePoint time : {TimePoint::min(), TimePoint::max(), TimePoint{}})
            for (const bool depth : {true, false, true}) {
                rig.push(depth, time);
                rig.collect(at(1s));
                rig.expectBalanced();
            }
    rig.sync.flush();
    rig.collect();
    rig.expectBalanced();
}

TEST(FrameSync, HoldsABoundedNumberOfFramesEvenIfNobodyAsks) {
    SyncRig rig;
    for (int i = 0; i < 1000; ++i) {
        rig.push(true, at(i * 33ms));
        rig.push(false, at(i * 33ms + 900s));
    }
    rig.expectBalanced();
    EXPECT_EQ(rig.sync.counters().depth.pending, FrameSync::kDepthKept);
    EXPECT_EQ(rig.sync.counters().color.pending, FrameSync::kColorKept);
}

} // namespace
