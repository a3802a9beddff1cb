#include "devices/live_feed.hpp"
#include "devices/openni2/openni_session.hpp"
#include "tests/unit/openni2/simulated_plug.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace autostereo::test {
namespace {

using namespace devices;
using namespace std::chrono_literals;

std::string messageOf(const std::string& uri) try {
    static_cast<void>(openInput(uri));
    return "";
} catch (const DeviceError& error) {
    return error.what();
}

class OpenNiInput : public testing::Test {
  protected:
    void SetUp() override {
        if (std::getenv("LD_LIBRARY_PATH") == nullptr)
            GTEST_SKIP() << "LD_LIBRARY_PATH does not lead to the simulated driver: run by ctest";
    }
};

TEST_F(OpenNiInput, FirstDeviceIsOpenedAsPinholes) {
    const Input input = openInput("openni2:");
    EXPECT_TRUE(input.depthIsLive && input.colorIsLive);
    EXPECT_NE(input.description.find("tofsim://room"), std::string::npos) << input.description;
    EXPECT_NE(input.description.find("160x144 depth at 30 fps"), std::string::npos);
    ASSERT_EQ(input.warnings.size(), 1U);
    ASSERT_TRUE(input.rig);
    const auto& depth = input.rig->depth.intrinsics;
    EXPECT_EQ(depth.width, 160);
    EXPECT_EQ(depth.cx, 79.5);
    EXPECT_EQ(input.rig->color.intrinsics.width, 320);
    EXPECT_NEAR(depth.fx, depth.fy, 1e-3) << "the simulated lenses have square pixels";
}

TEST_F(OpenNiInput, RegisteredDepthHasTheColorsCamera) {
    const Input input = openInput("openni2:tofsim://room?registered=on&depth=0.1mm");
    ASSERT_TRUE(input.rig);
    EXPECT_NEAR(input.rig->depth.intrinsics.fx, input.rig->color.intrinsics.fx * 160 / 320, 1e-6);
}

TEST_F(OpenNiInput, RigsOfOtherSizesAreRefused) {
    calib::SensorRig rig = *openInput("openni2:").rig;
    EXPECT_EQ(openInput("openni2:", rig).warnings.size(), 0U);
    rig.depth = rig.depth.resized(320, 288);
    EXPECT_THROW(static_cast<void>(openInput("openni2:", rig)), DeviceError);
}

TEST_F(OpenNiInput, MistakesAreNamed) {
    EXPECT_NE(messageOf("openni2:?depth=1cm").find("depth = '1cm' (allowed 1mm, 0.1mm)"),
              std::string::npos);
    EXPECT_NE(messageOf("openni2:?fps=3").find("unknown key fps"), std::string::npos);
    EXPECT_NE(messageOf("openni2:nobody").find("cannot open nobody"), std::string::npos);
}

/// Pairs from a feed; the limit only ends what would never end.
int pairsFrom(LiveFeed& feed, int wanted) {
    SteadyClock clock;
    const TimePoint end = clock.now() + 30s;
    int pairs = 0;
    while (pairs < wanted && clock.now() < end)
        pairs += feed.next(100ms) ? 1 : 0;
    return pairs;
}

TEST_F(OpenNiInput, AFeedSurvivesAReplug) {
    SteadyClock clock;
    LiveFeed feed(openInput("openni2:"), clock, {}, {.firstDelay = 10ms, .longestDelay = 100ms});
    ASSERT_EQ(pairsFrom(feed, 10), 10);
    const SimulatedPlug plug;
    plug.pull();
    std::this_thread::sleep_for(300ms);
    while (feed.next(0ms)) {
    }
    plug.plug();
    EXPECT_EQ(pairsFrom(feed, 10), 10);
    EXPECT_EQ(feed.counters().depth.reconnects, 1U);
    EXPECT_EQ(feed.counters().color.reconnects, 1U);
}

} // namespace
} // namespace autostereo::test
