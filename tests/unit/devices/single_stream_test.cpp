#include "devices/live_feed.hpp"
#include "devices/replay_feed.hpp"
#include "devices/single_stream.hpp"
#include "tests/support/fake_clock.hpp"
#include "tests/support/fake_source.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>

using namespace autostereo;
using namespace autostereo::devices;
using namespace std::chrono_literals;

namespace {

calib::CameraModel camera(int width, int height) {
    calib::CameraModel model;
    model.intrinsics = {.width = width,
                        .height = height,
                        .fx = 0.9 * width,
                        .fy = 0.9 * width,
                        .cx = 0.51 * width,
                        .cy = 0.48 * height};
    return model;
}

Input colorAlone(int frames) {
    Input input;
    input.uri = "test:color";
    input.color =
        std::make_unique<test::FakeSource>(PixelFormat::Rgba8, test::regularTimes(frames, 33ms));
    input.rig.emplace();
    input.rig->color = camera(1280, 720);
    return input;
}

Input depthAlone(int frames) {
    Input input;
    input.uri = "test:depth";
    input.depth =
        std::make_unique<test::FakeSource>(PixelFormat::Depth16, test::regularTimes(frames, 33ms));
    input.rig.emplace();
    input.rig->depth = camera(4, 3);
    return input;
}

TEST(SingleStream, ColorAloneStandsOnAFlatGrid) {
    Input input = completeStreams(colorAlone(3));
    ASSERT_TRUE(input.depth && input.color && input.rig);
    const calib::Intrinsics grid = input.rig->depth.intrinsics;
    ReplayFeed feed(std::move(input), {}, false);
    for (int i = 0; i < 3; ++i) {
        const auto pair = feed.next(0ms);
        ASSERT_TRUE(pair);
        EXPECT_EQ(pair->depth.metadata().capturedAt, pair->color.metadata().capturedAt);
        EXPECT_EQ(pair->depth.metadata().width, grid.width);
        EXPECT_EQ(pair->depth.metadata().height, grid.height);
        EXPECT_TRUE(std::ranges::all_of(pair->depth.depth(), [&](std::uint16_t counts) {
            return counts * pair->depth.metadata().depthUnitM == 1.0;
        }));
        EXPECT_TRUE(test::isWhole(pair->color));
    }
    EXPECT_EQ(feed.counters().pairs, 3U);
}

TEST(SingleStream, TheFlatGridReachesFromEdgeToEdgeOfThePicture) {
    const Input input = completeStreams(colorAlone(1));
    const calib::Intrinsics grid = input.rig->depth.intrinsics;
    const auto inPicture = [&](double x, double y) {
        const auto ray = input.rig->depth.unproject({x, y});
        return *input.rig->color.project({ray->x, ray->y, 1.0});
    };
    const auto first = inPicture(0, 0);
    const auto last = inPicture(grid.width - 1, grid.height - 1);
    // Newton's method stops at 1e-9 of a pixel or so.
    EXPECT_NEAR(first.x, -0.5, 1e-6);
    EXPECT_NEAR(first.y, -0.5, 1e-6);
    EXPECT_NEAR(last.x, 1279.5, 1e-6);
    EXPECT_NEAR(last.y, 719.5, 1e-6);
}

TEST(SingleStream, DepthAloneGetsAGreyPictureFromTheSameCamera) {
    Input input = completeStreams(depthAlone(3));
    ASSERT_TRUE(input.depth && input.color && input.rig);
    EXPECT_EQ(input.rig->color.intrinsics.fx, input.rig->depth.intrinsics.fx);
    ReplayFeed feed(std::move(input), {}, false);
    const auto pair = feed.next(0ms);
    ASSERT_TRUE(pair);
    EXPECT_EQ(pair->color.metadata().width, 4);
    EXPECT_EQ(pair->color.pixels().size(), 4U * 3U * 4U);
    EXPECT_EQ(pair->color.metadata().capturedAt, pair->depth.metadata().capturedAt);
}

TEST(SingleStream, ALoopRewindsTheRealSourceOnce) {
    ReplayFeed feed(completeStreams(colorAlone(3)), {}, true);
    for (std::uint64_t i = 0; i < 10; ++i) {
        const auto pair = feed.next(0ms);
        ASSERT_TRUE(pair) << i;
        EXPECT_EQ(pair->color.metadata().sequence, i);
        EXPECT_EQ(pair->depth.metadata().sequence, i);
    }
}

TEST(SingleStream, WorksWithAThreadForEachSide) {
    test::FakeClock clock;
    LiveFeed feed(completeStreams(depthAlone(500)), clock, {}, {});
    const auto limit = std::chrono::steady_clock::now() + 20s;
    std::uint64_t given = 0;
    while (!feed.ended() && std::chrono::steady_clock::now() < limit)
        if (const auto pair = feed.next(1ms)) ++given;
    ASSERT_TRUE(feed.ended());
    const FeedCounters counters = feed.counters();
    EXPECT_EQ(counters.depth.in, 500U);
    EXPECT_EQ(counters.color.in, 500U);
    EXPECT_EQ(counters.pairs, given + counters.dropped);
    EXPECT_GE(given, 1U);
}

TEST(SingleStream, LeavesACompleteInputAlone) {
    Input input = colorAlone(1);
    input.depth = std::move(depthAlone(1).depth);
    const Source* depth = input.depth.get();
    const Source* color = input.color.get();
    const Input same = completeStreams(std::move(input));
    EXPECT_EQ(same.depth.get(), depth);
    EXPECT_EQ(same.color.get(), color);
}

TEST(SingleStream, SaysWhatIsMissing) {
    const auto message = [](Input input) -> std::string {
        try {
            static_cast<void>(completeStreams(std::move(input)));
        } catch (const DeviceError& error) {
            return error.what();
        }
        return "";
    };
    Input bare = colorAlone(1);
    bare.rig.reset();
    EXPECT_NE(message(std::move(bare)).find("--rig"), std::string::npos);
    Input wrongCamera = depthAlone(1);
    wrongCamera.rig->depth.intrinsics.fx = 0;
    EXPECT_NE(message(std::move(wrongCamera)).find("fx"), std::string::npos);
    EXPECT_NE(message(Input{}).find("no stream"), std::string::npos);
}

// A camera alone goes away and comes back: its companion waits for it.
TEST(SingleStream, ALostCameraComesBackWithItsCompanion) {
    Input input = colorAlone(1);
    input.color = std::make_unique<test::FakeSource>(
        PixelFormat::Rgba8, test::regularTimes(2, 33ms), test::Then::Disconnects);
    int reopened = 0;
    input.reopen.color = [&reopened]() -> std::unique_ptr<Source> {
        ++reopened;
        return std::make_unique<test::FakeSource>(PixelFormat::Rgba8,
                                                  test::regularTimes(3, 33ms, 66ms));
    };
    input.colorIsLive = true;
    Input both = completeStreams(std::move(input));
    EXPECT_TRUE(both.depthIsLive);
    const TimePoint soon = std::chrono::steady_clock::now() + 10ms;
    for (int i = 0; i < 2; ++i)
        ASSERT_TRUE(std::holds_alternative<Frame>(both.color->read(soon)));
    for (int i = 0; i < 2; ++i)
        ASSERT_TRUE(std::holds_alternative<Frame>(both.depth->read(soon)));
    // Whoever reads first finds out; only the camera's own side is told.
    EXPECT_TRUE(std::holds_alternative<Timeout>(both.depth->read(soon)));
    const ReadResult lost = both.color->read(soon);
    ASSERT_TRUE(std::holds_alternative<Disconnected>(lost));
    EXPECT_EQ(std::get<Disconnected>(lost).reason, "cable pulled");
    EXPECT_TRUE(std::holds_alternative<Timeout>(both.color->read(soon))) << "said once";
    EXPECT_EQ(both.color->counters().delivered, 2U);

    both.color.reset();
    both.color = both.reopen.color();
    EXPECT_EQ(reopened, 1);
    EXPECT_EQ(both.color->counters().delivered, 0U) << "the new one's own";
    for (int i = 0; i < 3; ++i) {
        const TimePoint later = std::chrono::steady_clock::now() + 1s;
        ASSERT_TRUE(std::holds_alternative<Frame>(both.color->read(later)));
        ASSERT_TRUE(std::holds_alternative<Frame>(both.depth->read(later)));
    }
    EXPECT_EQ(both.depth->counters().delivered, 5U);
}

} // namespace
