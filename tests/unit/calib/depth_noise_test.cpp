#include "calib/depth_noise.hpp"
#include "devices/sim/simulation.hpp"
#include "devices/sim/tof_sensor.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <vector>

namespace autostereo::calib {
namespace {

using devices::sim::TofSample;
using devices::sim::TofSensor;

struct NoisyPicture {
    std::vector<std::uint16_t> depth, amplitude;
};

constexpr int kWidth = 320, kHeight = 288;

std::vector<NoisyPicture> stills(const std::vector<TofSample>& exact, int frames,
                                 bool noise = true) {
    const TofSensor sensor(kWidth, kHeight, 7, noise);
    std::vector<NoisyPicture> pictures;
    for (int frame = 0; frame < frames; ++frame) {
        NoisyPicture picture{std::vector<std::uint16_t>(exact.size()),
                             std::vector<std::uint16_t>(exact.size())};
        sensor.measure(exact, static_cast<std::uint64_t>(frame) + 1, picture.depth,
                       picture.amplitude);
        pictures.push_back(std::move(picture));
    }
    return pictures;
}

std::vector<StillFrame> asFrames(const std::vector<NoisyPicture>& pictures, bool amplitude = true) {
    std::vector<StillFrame> frames;
    frames.reserve(pictures.size());
    for (const NoisyPicture& picture : pictures)
        frames.push_back({picture.depth, amplitude
                                             ? std::span<const std::uint16_t>(picture.amplitude)
                                             : std::span<const std::uint16_t>{}});
    return frames;
}

/// Walls in steps from 0.6 m to 4 m: ranges and amplitudes of a living room, reflectance given.
std::vector<TofSample> staircase(double reflectance) {
    std::vector<TofSample> exact;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const int step = x / 20;
            const double z = 0.6 + 3.4 * step / 15.0;
            exact.push_back({static_cast<float>(z), devices::sim::tofAmplitude(reflectance, 1, z)});
        }
    return exact;
}

// A median of n absolute differences has a standard error of 1.17 / sqrt(n); with 5000 or more in
// each step's bin that is 1.6 % a bin. 3 % for the parameters is what 20 frames leave.
TEST(DepthNoise, FindsTheSimulatorsModel) {
    const auto pictures = stills(staircase(0.5), 20);
    const auto fit = measureDepthNoise(asFrames(pictures), 0.001);
    ASSERT_TRUE(fit && fit->amplitudeResidual && fit->rangeResidual);
    std::printf("floor %.3f mm, shot %.0f mm counts, growth %.3f mm/m^2; residuals %.4f, %.4f\n",
                1e3 * fit->noise.floorM, 1e3 * fit->noise.shotM, 1e3 * fit->noise.growthPerM,
                *fit->amplitudeResidual, *fit->rangeResidual);
    EXPECT_NEAR(fit->noise.floorM / 0.0018, 1, 0.03);
    EXPECT_NEAR(fit->noise.shotM / 3.032, 1, 0.03);
    EXPECT_LT(*fit->amplitudeResidual, 0.03);
    for (const double amplitude : {40.0, 200.0, 1000.0, 10000.0})
        EXPECT_NEAR(fit->noise.sigmaAtAmplitudeM(amplitude) / devices::sim::tofSigmaM(amplitude), 1,
                    0.03);
}

/// One reflectance, facing: amplitude 2500 / z^2, so shot noise is 3.032 / 2500 * z^2.
TEST(DepthNoise, FindsItByRangeWithoutAmplitude) {
    const auto pictures = stills(staircase(0.5), 20);
    const auto fit = measureDepthNoise(asFrames(pictures, false), 0.001);
    ASSERT_TRUE(fit && fit->rangeResidual);
    EXPECT_FALSE(fit->amplitudeResidual);
    EXPECT_EQ(fit->noise.shotM, DepthNoise{}.shotM) << "not measured: as it was";
    EXPECT_NEAR(fit->noise.floorM / 0.0018, 1, 0.05);
    EXPECT_NEAR(fit->noise.growthPerM / (3.032 / 2500), 1, 0.03);
}

TEST(DepthNoise, SaysWhatAnUnsuitableSceneCannotTell) {
    const std::vector<TofSample> wall(kWidth * kHeight, {2.0F, 600.0F});
    EXPECT_FALSE(measureDepthNoise(asFrames(stills(wall, 8)), 0.001)) << "one range, one amplitude";
    EXPECT_FALSE(measureDepthNoise(asFrames(stills(staircase(0.5), 2)), 0.001)) << "two frames";
    EXPECT_FALSE(measureDepthNoise(asFrames(stills(staircase(0.5), 8, false)), 0.001)) << "exact";
    EXPECT_FALSE(measureDepthNoise({}, 0.001));
    const std::vector<TofSample> nothing(kWidth * kHeight);
    EXPECT_FALSE(measureDepthNoise(asFrames(stills(nothing, 8)), 0.001)) << "no measurement";
}

TEST(DepthNoise, EdgesAndFlyingPixelsDoNotPullIt) {
    devices::Input input = devices::sim::openSimulation("sim:room?depth=320x288&color=64x36");
    std::vector<NoisyPicture> pictures;
    for (int i = 0; i < 12; ++i) {
        const auto frame = std::get<devices::Frame>(input.depth->read(devices::TimePoint::max()));
        const auto depth = frame.depth(), amplitude = frame.amplitude();
        pictures.push_back({{depth.begin(), depth.end()}, {amplitude.begin(), amplitude.end()}});
    }
    const auto fit = measureDepthNoise(asFrames(pictures), 0.001);
    ASSERT_TRUE(fit && fit->amplitudeResidual);
    EXPECT_FALSE(fit->rangeResidual) << "range does not explain a room of light and dark things";
    std::printf("room: floor %.3f mm, shot %.0f mm counts; residual %.4f\n",
                1e3 * fit->noise.floorM, 1e3 * fit->noise.shotM, *fit->amplitudeResidual);
    // Little of the room is bright enough to show the floor; what the model says of it is judged.
    for (const double amplitude : {50.0, 200.0, 1000.0, 3000.0})
        EXPECT_NEAR(fit->noise.sigmaAtAmplitudeM(amplitude) / devices::sim::tofSigmaM(amplitude), 1,
                    0.05);
}

} // namespace
} // namespace autostereo::calib
