#include "devices/frame_pool.hpp"
#include "devices/sim/scene_view.hpp"
#include "devices/sim/simulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace autostereo::devices::sim {
namespace {

using std::chrono::milliseconds;

std::vector<std::byte> bytesOf(const Frame& frame) {
    const auto pixels = frame.pixels();
    std::vector<std::byte> bytes(pixels.begin(), pixels.end());
    const auto amplitude = std::as_bytes(frame.amplitude());
    bytes.insert(bytes.end(), amplitude.begin(), amplitude.end());
    return bytes;
}

Frame nextFrame(Source& source) {
    ReadResult result = source.read(TimePoint{});
    EXPECT_TRUE(std::holds_alternative<Frame>(result));
    return std::get<Frame>(std::move(result));
}

/// Depth and colour of frame `index`, one after the other.
std::vector<std::byte> pairBytes(const std::string& uri, int index) {
    const Input input = openSimulation(uri);
    std::vector<std::byte> bytes;
    for (Source* source : {input.depth.get(), input.color.get()}) {
        for (int skipped = 0; skipped < index; ++skipped)
            (void)nextFrame(*source);
        const auto frame = bytesOf(nextFrame(*source));
        bytes.insert(bytes.end(), frame.begin(), frame.end());
    }
    return bytes;
}

std::string errorOf(const std::string& uri) {
    try {
        (void)openSimulation(uri);
    } catch (const DeviceError& error) {
        return error.what();
    }
    return "";
}

const std::string kSmall = "depth=64x48&color=96x54";

TEST(Simulation, HasTheDefaultsOfTheCommandLine) {
    const Input input = openSimulation("sim:calibration-board");
    ASSERT_TRUE(input.rig);
    const Frame depth = nextFrame(*input.depth), color = nextFrame(*input.color);
    EXPECT_EQ(depth.metadata().format, PixelFormat::Depth16);
    EXPECT_EQ(depth.metadata().width, 320);
    EXPECT_EQ(depth.metadata().height, 288);
    EXPECT_TRUE(depth.metadata().hasAmplitude);
    EXPECT_EQ(depth.metadata().depthUnitM, 0.001);
    EXPECT_EQ(color.metadata().format, PixelFormat::Rgba8);
    EXPECT_EQ(color.metadata().width, 1280);
    EXPECT_EQ(color.metadata().height, 720);
    EXPECT_EQ(input.nominalPeriod, Duration(33'333'333));
    EXPECT_EQ(input.rig->depth.intrinsics.width, 320);
    EXPECT_EQ(input.rig->color.intrinsics.height, 720);
}

TEST(Simulation, OffersEveryDepthSize) {
    for (const auto& [width, height] :
         {std::pair{176, 144}, {320, 288}, {512, 424}, {640, 480}, {640, 576}, {16, 16}}) {
        const std::string size = std::to_string(width) + "x" + std::to_string(height);
        const Input input = openSimulation("sim:room?color=64x36&depth=" + size);
        const Frame frame = nextFrame(*input.depth);
        EXPECT_EQ(frame.metadata().width, width);
        EXPECT_EQ(frame.depth().size(), static_cast<std::size_t>(width * height));
        const auto measured = std::count_if(frame.depth().begin(), frame.depth().end(),
                                            [](std::uint16_t depth) { return depth > 0; });
        EXPECT_GT(static_cast<double>(measured) / (width * height), 0.9) << size;
    }
}

TEST(Simulation, StampsTheMiddleOfEachExposure) {
    const Input input = openSimulation("sim:room?fps=25&" + kSmall);
    for (int k = 0; k < 3; ++k) {
        const Frame depth = nextFrame(*input.depth), color = nextFrame(*input.color);
        EXPECT_EQ(depth.metadata().sequence, static_cast<std::uint64_t>(k));
        EXPECT_EQ(depth.metadata().capturedAt.time_since_epoch(), milliseconds(40 * k));
        EXPECT_EQ(color.metadata().capturedAt.time_since_epoch(), milliseconds(40 * k + 4));
    }
}

TEST(Simulation, SameSeedGivesTheSameBytes) {
    const std::string uri = "sim:person?" + kSmall + "&seed=";
    const auto first = pairBytes(uri + "5", 3);
    EXPECT_EQ(first, pairBytes(uri + "5", 3));
    EXPECT_NE(first, pairBytes(uri + "6", 3));
    EXPECT_NE(first, pairBytes(uri + "5", 4));
}

TEST(Simulation, EndsAfterTheFramesAskedForAndStartsAgain) {
    const Input input = openSimulation("sim:person?frames=2&" + kSmall);
    const auto first = bytesOf(nextFrame(*input.depth));
    (void)nextFrame(*input.depth);
    EXPECT_TRUE(std::holds_alternative<Ended>(input.depth->read(TimePoint{})));
    EXPECT_TRUE(std::holds_alternative<Ended>(input.depth->read(TimePoint{})));
    EXPECT_TRUE(input.depth->rewind());
    EXPECT_EQ(bytesOf(nextFrame(*input.depth)), first);
    EXPECT_EQ(input.depth->counters().delivered, 3U);
}

TEST(Simulation, CountsFramesThatFoundNoSlot) {
    const Input input = openSimulation("sim:room?" + kSmall);
    std::vector<Frame> held;
    for (std::size_t i = 0; i < kFramesOnTheWay; ++i)
        held.push_back(nextFrame(*input.depth));
    EXPECT_TRUE(std::holds_alternative<Timeout>(input.depth->read(TimePoint{})));
    EXPECT_EQ(input.depth->counters().starved, 1U);
    held.clear();
    EXPECT_EQ(nextFrame(*input.depth).metadata().sequence, kFramesOnTheWay + 1);
}

// Without noise the frames are the exact answer, rounded, at their own moment.
TEST(Simulation, WithoutNoiseEqualsTheTruth) {
    const Input input = openSimulation("sim:person?noise=off&" + kSmall);
    const auto scene = makeScene("person", 1);
    for (int k = 0; k < 20; ++k) {
        const Frame depth = nextFrame(*input.depth), color = nextFrame(*input.color);
        if (k % 7 != 0) continue;
        const Snapshot atDepth = scene->at(k / 30.0), atColor = scene->at(k / 30.0 + 0.004);
        for (std::size_t pixel = 0; pixel < depth.pixelCount(); ++pixel) {
            const auto truth = hitAtPixel(atDepth, input.rig->depth, input.rig->colorFromDepth,
                                          {pixel % 64, pixel / 64});
            ASSERT_TRUE(truth);
            // Half a millimetre of rounding; stamps are whole nanoseconds.
            ASSERT_NEAR(depth.depth()[pixel], 1000 * truth->distance, 0.51) << pixel;
        }
        for (std::size_t pixel = 0; pixel < color.pixelCount(); ++pixel) {
            const auto truth = hitAtPixel(atColor, input.rig->color, {}, {pixel % 96, pixel / 96});
            ASSERT_TRUE(truth);
            const auto red = std::to_integer<int>(color.pixels()[4 * pixel]);
            ASSERT_NEAR(red, truth->color.r, 0.51) << pixel;
            ASSERT_EQ(color.pixels()[4 * pixel + 3], std::byte{255});
        }
    }
}

// The kinds of bad pixels that real sensors have, in believable shares of the default picture:
// a highlight on the ball (some pixels), a black bowl and grazing surfaces, flying edges.
TEST(Simulation, HasAllKindsOfBadPixelsInBelievableShares) {
    const Input noisy = openSimulation("sim:person?color=64x36");
    const Input exact = openSimulation("sim:person?color=64x36&noise=off");
    const Frame measured = nextFrame(*noisy.depth), truth = nextFrame(*exact.depth);
    int saturated = 0, noReturn = 0, flying = 0;
    for (std::size_t i = 0; i < measured.pixelCount(); ++i) {
        const int depth = measured.depth()[i];
        if (depth == 0) {
            ++(measured.amplitude()[i] == 65535 ? saturated : noReturn);
        } else if (std::abs(depth - truth.depth()[i]) > 100) {
            ++flying;
        }
    }
    const auto share = [&](int count) {
        return count / static_cast<double>(measured.pixelCount());
    };
    EXPECT_GT(saturated, 3);
    EXPECT_LT(share(saturated), 0.005);
    EXPECT_GT(share(noReturn), 0.001);
    EXPECT_LT(share(noReturn), 0.05);
    EXPECT_GT(share(flying), 0.003);
    EXPECT_LT(share(flying), 0.03);
}

// Sigma is stated as 1.5 of 255; rounding the noise adds 1/12. Standard error with 6912 values of
// one picture: 0.9 %.
TEST(Simulation, ColourNoiseIsLight) {
    const Input noisy = openSimulation("sim:room?depth=16x16&color=64x36");
    const Input exact = openSimulation("sim:room?depth=16x16&color=64x36&noise=off");
    const Frame measured = nextFrame(*noisy.color), truth = nextFrame(*exact.color);
    double sum = 0, squares = 0;
    int count = 0;
    for (std::size_t i = 0; i < measured.pixels().size(); ++i) {
        const int value = std::to_integer<int>(truth.pixels()[i]);
        const int error = std::to_integer<int>(measured.pixels()[i]) - value;
        if (i % 4 == 3) {
            ASSERT_EQ(error, 0);
        } else if (value > 6 && value < 249) { // not clamped
            sum += error;
            squares += error * error;
            ++count;
        }
    }
    EXPECT_NEAR(sum / count, 0, 4 * 1.53 / std::sqrt(count));
    EXPECT_NEAR(std::sqrt(squares / count), std::sqrt(1.5 * 1.5 + 1.0 / 12), 4 * 0.009 * 1.53);
}

TEST(Simulation, ExplainsWhatIsWrongWithAnAddress) {
    const auto says = [](const std::string& uri, const std::string& part) {
        const std::string error = errorOf(uri);
        EXPECT_NE(error.find(part), std::string::npos) << uri << ": " << error;
        EXPECT_EQ(error.find('\n'), std::string::npos);
    };
    says("sim:kitchen", "allowed room, person, calibration-board");
    says("sim:", "allowed room, person, calibration-board");
    says("sim:room?colour=64x36", "allowed seed, fps, depth, color, noise, frames");
    says("sim:room?noise=some", "allowed on, off");
    says("sim:room?fps=0", "allowed 1 to 240");
    says("sim:room?fps=nan", "allowed 1 to 240");
    says("sim:room?seed=-1", "seed");
    says("sim:room?frames=0", "frames");
    for (const char* size : {"64", "64x", "x64", "8x64", "64x1025", "64x64x", "-64x64", "a"}) {
        says(std::string("sim:room?depth=") + size, "allowed WIDTHxHEIGHT from 16x16 to 1024x1024");
    }
    says("sim:room?color=64x5000", "16x16 to 4096x4096");
}

} // namespace
} // namespace autostereo::devices::sim
