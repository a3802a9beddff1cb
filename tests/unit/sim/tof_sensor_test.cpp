#include "devices/sim/tof_sensor.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace autostereo::devices::sim {
namespace {

struct Measured {
    std::vector<std::uint16_t> depth;
    std::vector<std::uint16_t> amplitude;
};

constexpr int kSide = 128;
constexpr std::size_t kPixels = kSide * kSide;

Measured measure(const std::vector<TofSample>& exact, std::uint64_t frame, std::uint64_t seed = 1,
                 bool noise = true) {
    Measured result{std::vector<std::uint16_t>(kPixels), std::vector<std::uint16_t>(kPixels)};
    TofSensor(kSide, kSide, seed, noise).measure(exact, frame, result.depth, result.amplitude);
    return result;
}

std::vector<TofSample> wall(double distance, double reflectance) {
    return std::vector<TofSample>(
        kPixels, {static_cast<float>(distance), tofAmplitude(reflectance, 1.0, distance)});
}

TEST(TofSigma, IsTwoMillimetresAtOneMetreAndEightAtThree) {
    EXPECT_NEAR(tofSigmaM(tofAmplitude(0.7, 1, 1)), 0.0020, 0.0001);
    EXPECT_NEAR(tofSigmaM(tofAmplitude(0.7, 1, 3)), 0.0080, 0.0001);
    EXPECT_GT(tofSigmaM(tofAmplitude(0.2, 1, 3)), 0.020); // darker: noisier
}

// 16384 samples: the mean is known to sigma / 128 and sigma to 0.55 %; four of those are allowed.
// Rounding to millimetres adds 1/12 mm^2 of variance.
TEST(TofSensor, NoiseFollowsTheModel) {
    for (const double distance : {0.8, 1.0, 2.0, 3.0, 4.0}) {
        const auto exact = wall(distance, 0.7);
        const Measured measured = measure(exact, 5);
        double sum = 0, squares = 0;
        for (const std::uint16_t depth : measured.depth) {
            const double error = depth - 1000 * distance;
            sum += error;
            squares += error * error;
        }
        const double mean = sum / kPixels;
        const double sigma = std::sqrt(squares / kPixels - mean * mean);
        const double model = std::sqrt(
            std::pow(1000 * tofSigmaM(static_cast<double>(exact[0].amplitude)), 2) + 1.0 / 12);
        EXPECT_NEAR(mean, 0, 4 * model / 128) << distance;
        EXPECT_NEAR(sigma / model, 1, 4 * 0.0055) << distance;
    }
}

double correlation(const Measured& a, const Measured& b, double mean) {
    double product = 0, squares = 0;
    for (std::size_t i = 0; i < kPixels; ++i) {
        product += (a.depth[i] - mean) * (b.depth[i] - mean);
        squares += (a.depth[i] - mean) * (a.depth[i] - mean);
    }
    return product / squares;
}

// A fifth of the noise stays for one frame: 0.2 * 0.98. Standard error of a correlation: 1 / 128.
TEST(TofSensor, FramesJitterAlmostIndependently) {
    const auto exact = wall(2.5, 0.6);
    const Measured first = measure(exact, 10), second = measure(exact, 11),
                   third = measure(exact, 12);
    EXPECT_NEAR(correlation(first, second, 2500), 0.196, 4.0 / 128);
    EXPECT_NEAR(correlation(first, third, 2500), 0.0, 4.0 / 128);
    EXPECT_NE(first.depth, second.depth);
}

TEST(TofSensor, IsAPureFunctionOfSeedAndFrame) {
    const auto exact = wall(1.5, 0.5);
    const Measured first = measure(exact, 7), again = measure(exact, 7);
    EXPECT_EQ(first.depth, again.depth);
    EXPECT_EQ(first.amplitude, again.amplitude);
    EXPECT_NE(first.depth, measure(exact, 7, 2).depth);
}

TEST(TofSensor, WithoutNoiseRoundsTheTruth) {
    auto exact = wall(1.2344, 0.5);
    exact[0] = {1.2346F, 30000};
    exact[1] = {0, 0};
    const Measured measured = measure(exact, 3, 1, false);
    EXPECT_EQ(measured.depth[0], 1235);
    EXPECT_EQ(measured.amplitude[0], 30000);
    EXPECT_EQ(measured.depth[1], 0);
    EXPECT_EQ(measured.depth[2], 1234);
    EXPECT_EQ(measured.amplitude[2], std::lround(exact[2].amplitude));
}

TEST(TofSensor, BrightIsSaturatedAndDarkReturnsNothing) {
    const Measured bright = measure(wall(0.3, 0.8), 1); // 44 000 counts
    const Measured dark = measure(wall(3.0, 0.03), 1);  // 17 counts
    for (std::size_t i = 0; i < kPixels; ++i) {
        ASSERT_EQ(bright.depth[i], 0);
        ASSERT_EQ(bright.amplitude[i], 65535);
        ASSERT_EQ(dark.depth[i], 0);
        ASSERT_LT(dark.amplitude[i], TofSensor::kLeast);
    }
}

// A step from 1 m to 2 m: pixels beside it are mixed one time in four (standard error with 256
// such pixels: 2.7 %), no others are; amplitudes weigh, so a mixed pixel lies nearer to the front.
TEST(TofSensor, FlyingPixelsStandAtDepthEdgesOnly) {
    auto exact = wall(1.0, 0.6);
    const TofSample far{2.0F, tofAmplitude(0.6, 1, 2.0)};
    for (std::size_t i = 0; i < kPixels; ++i) {
        if (i % kSide >= kSide / 2) exact[i] = far;
    }
    const Measured measured = measure(exact, 4);
    int flying = 0;
    for (std::size_t i = 0; i < kPixels; ++i) {
        const bool mixed = measured.depth[i] > 1040 && measured.depth[i] < 1940;
        const std::size_t column = i % kSide;
        const bool atEdge = column == kSide / 2 - 1 || column == kSide / 2;
        if (!atEdge) {
            ASSERT_FALSE(mixed) << "column " << column;
        }
        flying += mixed ? 1 : 0;
    }
    EXPECT_NEAR(flying / 256.0, 0.25, 4 * 0.027);
    // One of four sub-rays strays: (3 * 2 m * A + 1 m * 4 A) / (3 A + 4 A) = 1.43 m from behind.
    int asExpected = 0;
    for (std::size_t row = 0; row < kSide; ++row) {
        const int depth = measured.depth[row * kSide + kSide / 2];
        asExpected += std::abs(depth - 1429) < 20 ? 1 : 0;
    }
    EXPECT_GT(asExpected, 15);
}

TEST(TofSensor, PixelsWithoutARayStayEmpty) {
    auto exact = wall(1.0, 0.5);
    for (std::size_t i = 0; i < kSide; ++i)
        exact[i] = {0, 0};
    const Measured measured = measure(exact, 1);
    for (std::size_t i = 0; i < kSide; ++i) {
        EXPECT_EQ(measured.depth[i], 0);
        EXPECT_EQ(measured.amplitude[i], 0);
        EXPECT_NEAR(measured.depth[i + kSide], 1000, 15); // and are no neighbours to mix with
    }
}

} // namespace
} // namespace autostereo::devices::sim
