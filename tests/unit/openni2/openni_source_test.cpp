#include "devices/openni2/openni_source.hpp"

#include "devices/input.hpp"
#include "devices/sim/simulation.hpp"
#include "tests/support/data.hpp"
#include "tests/unit/openni2/simulated_plug.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <thread>

// Through the real OpenNI2 library and the simulated camera as one of its drivers.

namespace autostereo::test {
namespace {

using namespace devices;
using namespace devices::openni2;
using namespace std::chrono_literals;

const DeviceRequest kDepth{"", {Sensor::Depth, Sensor::Infrared}};
const DeviceRequest kColor{"", {Sensor::Color}};

std::unique_ptr<OpenNiSource> open(const DeviceRequest& request) {
    return std::make_unique<OpenNiSource>(std::make_unique<Device>(request),
                                          request.sensors.front());
}

/// Reads until a frame comes; nothing after two seconds or a loss.
std::optional<Frame> nextFrame(Source& source) {
    SteadyClock clock;
    auto result = source.read(clock.now() + 2s);
    if (auto* frame = std::get_if<Frame>(&result)) return std::move(*frame);
    return std::nullopt;
}

class OpenNi : public testing::Test {
  protected:
    void SetUp() override {
        if (std::getenv("LD_LIBRARY_PATH") == nullptr)
            GTEST_SKIP() << "LD_LIBRARY_PATH does not lead to the simulated driver: run by ctest";
    }

    /// Frame `number` of the streams (from 1) as the simulation makes it.
    struct Truth {
        Frame depth, color;
    };
    /// Copies of the next `count` frames, none computed meanwhile: a camera waits for nobody.
    std::vector<Frame> record(Source& source, int count) {
        std::vector<Frame> frames;
        for (int i = 0; i < count; ++i)
            if (const auto frame = nextFrame(source)) frames.push_back(copyOf(*frame));
        return frames;
    }
    const Truth& truth(std::uint64_t number) {
        while (truths.size() < number) {
            auto depth = simulated.depth->read({});
            auto color = simulated.color->read({});
            // Copies: the simulation's pools have few slots.
            truths.push_back({copyOf(std::get<Frame>(depth)), copyOf(std::get<Frame>(color))});
        }
        return truths[number - 1];
    }
    Frame copyOf(const Frame& frame) {
        pools.push_back(std::make_unique<FramePool>(1));
        auto copy = pools.back()->acquire(frame.metadata());
        std::ranges::copy(frame.pixels(), copy->pixels().begin());
        std::ranges::copy(frame.amplitude(), copy->amplitude().begin());
        return std::move(*copy);
    }

    Input simulated = sim::openSimulation("sim:room?depth=160x144&color=320x180");
    std::vector<std::unique_ptr<FramePool>> pools;
    std::vector<Truth> truths;
};

TEST_F(OpenNi, DepthAndInfraredAreBitExact) {
    const auto source = open(kDepth);
    const std::vector<Frame> frames = record(*source, 30);
    ASSERT_EQ(frames.size(), 30U);
    std::uint64_t last = 0;
    for (const Frame& frame : frames) {
        const FrameMetadata& data = frame.metadata();
        EXPECT_EQ(data.format, PixelFormat::Depth16);
        EXPECT_EQ(data.depthUnitM, 1e-3);
        ASSERT_TRUE(data.hasAmplitude);
        EXPECT_GT(data.sequence, last);
        last = data.sequence;
        const Frame& expected = truth(data.sequence).depth;
        ASSERT_TRUE(std::ranges::equal(frame.depth(), expected.depth())) << data.sequence;
        ASSERT_TRUE(std::ranges::equal(frame.amplitude(), expected.amplitude()));
    }
    // Only depth whose infrared came too late for this machine; its numbers are missing here.
    EXPECT_LE(source->counters().damaged, last - frames.size());
}

TEST_F(OpenNi, FineDepthIsBitExact) {
    DeviceRequest request = kDepth;
    request.fineDepth = true;
    const auto source = open(request);
    const std::vector<Frame> frames = record(*source, 10);
    ASSERT_EQ(frames.size(), 10U);
    for (const Frame& frame : frames) {
        EXPECT_EQ(frame.metadata().depthUnitM, 1e-4);
        const Frame& expected = truth(frame.metadata().sequence).depth;
        for (std::size_t p = 0; p < frame.pixelCount(); ++p) {
            const int mm = expected.depth()[p];
            ASSERT_EQ(frame.depth()[p], mm > 6553 ? 0 : 10 * mm);
        }
    }
}

TEST_F(OpenNi, ColorIsBitExact) {
    const auto source = open(kColor);
    const std::vector<Frame> frames = record(*source, 10);
    ASSERT_EQ(frames.size(), 10U);
    for (const Frame& frame : frames) {
        ASSERT_EQ(frame.metadata().format, PixelFormat::Rgb8);
        const Frame& expected = truth(frame.metadata().sequence).color;
        for (std::size_t p = 0; p < frame.pixelCount(); ++p)
            ASSERT_TRUE(std::ranges::equal(frame.pixels().subspan(3 * p, 3),
                                           expected.pixels().subspan(4 * p, 3)));
    }
}

TEST_F(OpenNi, RegisteredDepthIsWhatTheColorCameraSees) {
    DeviceRequest request = kDepth;
    request.registered = true;
    const auto source = open(request);
    EXPECT_TRUE(source->device().registered());
    const auto registered = nextFrame(*source);
    ASSERT_TRUE(registered);
    // Another picture than the depth camera's own, of the same room.
    const auto mean = [](std::span<const std::uint16_t> depth) {
        double sum = 0;
        for (const std::uint16_t mm : depth)
            sum += mm;
        return sum / static_cast<double>(depth.size());
    };
    const Frame& own = truth(1).depth;
    EXPECT_FALSE(std::ranges::equal(registered->depth(), own.depth()));
    EXPECT_NEAR(mean(registered->depth()), mean(own.depth()), 0.3 * mean(own.depth()));
}

TEST_F(OpenNi, StampsAreHostTimesBeforeArrival) {
    const auto source = open(kDepth);
    SteadyClock clock;
    TimePoint last{};
    for (int i = 0; i < 10; ++i) {
        const auto frame = nextFrame(*source);
        ASSERT_TRUE(frame);
        const TimePoint at = frame->metadata().capturedAt;
        EXPECT_GT(at, last);
        EXPECT_LE(at, clock.now());
        EXPECT_GT(at, clock.now() - 1s);
        last = at;
    }
}

TEST_F(OpenNi, UnknownDevicesAreNotFound) {
    try {
        const Device device({"tofsim://nowhere", {Sensor::Depth}});
        FAIL();
    } catch (const DeviceError& error) {
        EXPECT_TRUE(error.notFound());
        EXPECT_NE(std::string(error.what()).find("cannot open tofsim://nowhere"),
                  std::string::npos);
    }
}

TEST_F(OpenNi, OpensAndClosesAgainAndAgain) {
    const auto session = Session::get();
    const int cycles = fullCampaign() ? 500 : 25;
    for (int i = 0; i < cycles; ++i) {
        const auto depth = open(kDepth);
        const auto color = open(kColor);
        ASSERT_TRUE(nextFrame(*depth)) << i;
        ASSERT_TRUE(nextFrame(*color)) << i;
    }
}

TEST_F(OpenNi, ALostDeviceIsNotLentAgain) {
    const auto session = Session::get();
    const SimulatedPlug plug;
    auto color = open(kColor);
    plug.pull();
    plug.plug();
    EXPECT_THROW(open(kDepth), DeviceError) << "the library would lend the silent one";
    color.reset();
    EXPECT_TRUE(nextFrame(*open(kDepth)));
}

TEST_F(OpenNi, IsLostAndFoundAtAnyMoment) {
    const auto session = Session::get();
    const SimulatedPlug plug;
    std::mt19937 random(1);
    std::uniform_int_distribution<int> anyMoment(0, 60);
    SteadyClock clock;
    const int rounds = fullCampaign() ? 100 : 10;
    for (int i = 0; i < rounds; ++i) {
        auto depth = open(kDepth);
        auto color = open(kColor);
        std::jthread puller([&, wait = anyMoment(random)] {
            std::this_thread::sleep_for(std::chrono::milliseconds(wait));
            plug.pull();
        });
        const TimePoint end = clock.now() + 2s;
        bool lost = false;
        while (!lost && clock.now() < end)
            lost = std::holds_alternative<Disconnected>(depth->read(clock.now() + 50ms));
        EXPECT_TRUE(lost) << "round " << i;
        EXPECT_TRUE(std::holds_alternative<Disconnected>(color->read(clock.now() + 50ms)));
        puller.join();
        EXPECT_THROW(open(kDepth), DeviceError) << "it is away";
        depth.reset();
        color.reset();
        plug.plug();
        ASSERT_TRUE(nextFrame(*open(kDepth))) << "round " << i;
    }
}

} // namespace
} // namespace autostereo::test
