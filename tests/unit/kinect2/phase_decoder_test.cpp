#include "devices/kinect2/phase_decoder.hpp"

#include "devices/replay/image_files.hpp"
#include "tests/oracle/kinect2_oracle.hpp"
#include "tests/support/data.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <numeric>

namespace autostereo::test {
namespace {

using namespace devices::kinect2;

PhaseDecoder decoderOf(const Kinect2Unit& unit, const DecodeParams& params = {}) {
    return {parsePhasePage(phasePage(unit)), parseDepthCameraPage(depthCameraPage(unit)), params};
}

DepthPicture decode(const PhaseDecoder& decoder, const RawDepthFrame& frame) {
    DepthPicture picture;
    decoder.decode(frame, picture);
    return picture;
}

/// Blocks of 64 x 53 pixels from 0.8 to 3.6 m, light falling with the square of the distance.
LitPoint stairs(int x, int y) {
    const double depth = 800 + 400 * ((x / 64 + y / 53) % 8);
    return {depth, std::min(1500.0, 1.6e9 / (depth * depth))};
}

struct Errors {
    double mean = 0, rms = 0, worst = 0;
    int count = 0;
};

Errors errorsOf(const DepthPicture& picture, const LitScene& truth) {
    Errors result;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const float depth = picture.depthMm[static_cast<std::size_t>(y * kWidth + x)];
            if (depth <= 0) continue;
            const double error = depth - truth(x, y).depthMm;
            ++result.count;
            result.mean += error;
            result.rms += error * error;
            result.worst = std::max(result.worst, std::abs(error));
        }
    result.mean /= result.count;
    result.rms = std::sqrt(result.rms / result.count);
    return result;
}

/// The offsets of a real unit; empty where the data is missing.
Kinect2Unit realUnit() {
    Kinect2Unit unit = inventedUnit();
    devices::ImageReader reader;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto header = reader.open(dataDir() / "camera-calibrations/kinect-v2" /
                                        ("p0table_" + std::to_string(i) + ".png"));
        EXPECT_EQ(header.bytes(), kPixels * 2);
        reader.decode(std::as_writable_bytes(std::span(unit.offsets[i])));
    }
    return unit;
}

TEST(PhaseDecoder, AgreesWithTruthToTheSamplesResolution) {
    const Kinect2Unit unit = inventedUnit();
    std::mt19937_64 random(1);
    const auto picture = decode(decoderOf(unit), expose(unit, stairs, 0, random));
    const Errors errors = errorsOf(picture, stairs);
    EXPECT_EQ(errors.count, (kWidth - 2) * kHeight) << "every pixel but the two unused columns";
    // 11 bits: steps of 1 to 8 counts at these amplitudes.
    EXPECT_LE(errors.rms, 0.25);
    EXPECT_LE(errors.worst, 1.7);
    EXPECT_LE(std::abs(errors.mean), 0.01);
    std::printf("quantisation alone: rms %.3f mm, worst %.2f mm\n", errors.rms, errors.worst);
}

TEST(PhaseDecoder, AgreesWithTheOracle) {
    Kinect2Unit unit = inventedUnit();
    unit.p1 = 0.0011F;
    unit.p2 = -0.0007F;
    unit.zOffsetMm = -3.25F;
    std::mt19937_64 random(2);
    const auto frame = expose(unit, stairs, 4, random);
    const auto picture = decode(decoderOf(unit), frame);
    int compared = 0;
    for (int y = 0; y < kHeight; y += 7)
        for (int x = 1; x < kWidth - 1; x += 5) {
            const auto phases = oracle::phasesAt(frame, unit, x, y);
            const auto pixel = static_cast<std::size_t>(y * kWidth + x);
            ASSERT_TRUE(phases);
            const double path = 1250 * oracle::bestFit(*phases, unit).path;
            const double depth = oracle::depthOf(rayOf(unit, x, y), path) + unit.zOffsetMm;
            if (picture.depthMm[pixel] == 0) continue;
            ++compared;
            // Floats of 24 bits through a path of up to 10 m: steps of 1 um, a dozen roundings.
            ASSERT_NEAR(picture.depthMm[pixel], depth, 0.01) << x << ' ' << y;
            const auto& a = phases->amplitudes;
            ASSERT_NEAR(picture.infrared[pixel], 16 * (a[0] + a[1] + a[2]) / 3, 1.01);
        }
    EXPECT_GT(compared, 6000);
}

TEST(PhaseDecoder, RealOffsetsLeaveNoBias) {
    AUTOSTEREO_NEED_DATA("camera-calibrations/kinect-v2/p0table_0.png");
    const Kinect2Unit unit = realUnit();
    const PhaseDecoder decoder = decoderOf(unit);
    std::mt19937_64 random(3);
    for (const double depth : {800.0, 1500.0, 3000.0, 4500.0}) {
        const auto wall = [&](int, int) {
            return LitPoint{depth, std::min(1500.0, 1.6e9 / (depth * depth))};
        };
        const Errors errors = errorsOf(decode(decoder, expose(unit, wall, 4, random)), wall);
        // The mean of 216240 pixels with noise below 10 mm is good to 0.02 mm.
        EXPECT_LE(std::abs(errors.mean), 0.05) << depth;
        EXPECT_GT(errors.count, 216000) << depth;
        std::printf("%.1f m: mean %+.4f mm, rms %.3f mm\n", depth / 1000, errors.mean, errors.rms);
    }
}

/// A room corner with a slanted floor, boxes and thin poles.
LitPoint clutter(int x, int y, double brightness) {
    double depth = 4200;
    if (y > 260) depth = std::min(depth, 4200 * 160.0 / (y - 100));
    if (x > 60 && x < 200 && y > 120 && y < 300) depth = 1800 + 2 * (x - 60);
    if (x > 300 && x < 420 && y > 60 && y < 330) depth = 2600 + 300 * std::sin(0.05 * y);
    if (x % 61 < 5 && y > 30 && y < 240) depth = 1300;
    const double reflectance = (x / 24 + y / 24) % 2 == 0 ? 1 : 0.35;
    return {depth, brightness * reflectance * std::pow(4200 / depth, 2)};
}

TEST(PhaseDecoder, FewerWrongWrapsThanTheReference) {
    const Kinect2Unit unit = inventedUnit();
    std::mt19937_64 random(4);
    DecodeParams params;
    params.leastConfidence = 0;
    params.leastAmplitude = 0;
    params.nearestM = 0;
    const PhaseDecoder decoder = decoderOf(unit, params);
    std::printf("%10s %10s %12s %12s %12s\n", "amplitude", "valid", "reference", "ours",
                "ours, all");
    for (const double brightness : {10.0, 15.0, 25.0, 40.0, 60.0}) {
        const auto scene = [&](int x, int y) { return clutter(x, y, brightness); };
        const auto frame = expose(unit, scene, 8, random);
        const auto picture = decode(decoder, frame);
        std::vector<std::pair<float, bool>> ours;
        int valid = 0, wrongReference = 0, wrongAll = 0;
        for (int y = 0; y < kHeight; ++y)
            for (int x = 1; x < kWidth - 1; ++x) {
                const auto pixel = static_cast<std::size_t>(y * kWidth + x);
                const auto phases = oracle::phasesAt(frame, unit, x, y);
                const auto reference = oracle::referenceUnwrapping(*phases);
                const double truth = scene(x, y).depthMm;
                // Wraps lie 1.9 m of path and more apart.
                const auto wrong = [&](double depth) { return std::abs(depth - truth) > 500; };
                if (reference.accepted) {
                    ++valid;
                    const double depth = oracle::depthOf(rayOf(unit, x, y), 1250 * reference.path);
                    wrongReference += wrong(depth) ? 1 : 0;
                }
                const bool bad = wrong(picture.depthMm[pixel]);
                wrongAll += bad ? 1 : 0;
                ours.emplace_back(picture.confidence[pixel], bad);
            }
        std::ranges::sort(ours, [](const auto& a, const auto& b) { return a.first > b.first; });
        const auto wrongOurs = std::count_if(ours.begin(), ours.begin() + valid,
                                             [](const auto& p) { return p.second; });
        std::printf("%10.0f %10d %12d %12ld %12d   cut at %.3f\n", brightness, valid,
                    wrongReference, wrongOurs, wrongAll,
                    static_cast<double>(ours[static_cast<std::size_t>(valid) - 1].first));
        EXPECT_LT(wrongOurs, wrongReference);
    }
}

TEST(PhaseDecoder, PixelsThatMeasuredNothingHaveNoDepth) {
    Kinect2Unit unit = inventedUnit();
    unit.defects = {{200, 50}};
    std::mt19937_64 random(6);
    const auto scene = [](int x, int y) {
        if (y < 100) return LitPoint{1000, 0};     // nothing comes back
        if (y < 120) return LitPoint{1000, 20000}; // overexposed
        if (y < 140) return LitPoint{200, 1000};   // nearer than asked for
        return LitPoint{1500.0 + x, 1000};
    };
    const auto picture = decode(decoderOf(unit), expose(unit, scene, 8, random));
    int lucky = 0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 1; x < kWidth - 1; ++x) {
            const auto pixel = static_cast<std::size_t>(y * kWidth + x);
            const bool hasDepth = picture.depthMm[pixel] > 0;
            if (y < 100) {
                lucky += hasDepth ? 1 : 0;
            } else {
                const bool measured = y >= 140 && !(y == 200 && x == 50);
                ASSERT_EQ(hasDepth, measured) << x << ' ' << y;
            }
            ASSERT_EQ(picture.infrared[pixel] == 65535, y >= 100 && y < 120) << x << ' ' << y;
        }
    // Noise alone sometimes looks like light from one place.
    std::printf("depth from noise alone: %d of %d\n", lucky, 100 * kWidth);
    EXPECT_LT(lucky, 0.01 * 100 * kWidth);
    for (const std::size_t unused : {std::size_t{0}, std::size_t{kWidth - 1}})
        EXPECT_EQ(picture.depthMm[300 * kWidth + unused], 0);
}

TEST(PhaseDecoder, AnyBytesAndAnyLensGiveNumbers) {
    Kinect2Unit unit = inventedUnit();
    RawDepthFrame frame;
    std::mt19937 random(7);
    for (const float focal : {365.0F, 1e-3F, 1e-38F, 1e38F}) {
        unit.fx = focal;
        for (std::byte& byte : frame.bytes)
            byte = static_cast<std::byte>(random());
        const auto picture = decode(decoderOf(unit), frame);
        for (std::size_t i = 0; i < kPixels; ++i) {
            ASSERT_TRUE(picture.depthMm[i] >= 0 && picture.depthMm[i] < 20000) << i;
            ASSERT_TRUE(picture.confidence[i] >= 0 && picture.confidence[i] <= 1) << i;
        }
    }
}

TEST(PhaseDecoder, NeighboursHelp) {
    const Kinect2Unit unit = inventedUnit();
    std::mt19937_64 random(5);
    DecodeParams params;
    params.leastConfidence = 0;
    params.leastAmplitude = 0;
    params.nearestM = 0;
    const auto scene = [](int x, int y) { return clutter(x, y, 40); };
    const auto frame = expose(unit, scene, 8, random);
    const auto picture = decode(decoderOf(unit, params), frame);
    int wrongAlone = 0, wrong = 0;
    for (int y = 4; y < kHeight; y += 16)
        for (int x = 1; x < kWidth - 1; ++x) {
            const double truth = scene(x, y).depthMm;
            const double path =
                1250 * oracle::bestFit(*oracle::phasesAt(frame, unit, x, y), unit).path;
            const double alone = oracle::depthOf(rayOf(unit, x, y), path);
            const double ours = picture.depthMm[static_cast<std::size_t>(y * kWidth + x)];
            wrongAlone += std::abs(alone - truth) > 500 ? 1 : 0;
            wrong += std::abs(ours - truth) > 500 ? 1 : 0;
        }
    std::printf("wrong wraps: each pixel alone %d, with its neighbours %d\n", wrongAlone, wrong);
    EXPECT_LT(wrong, 0.7 * wrongAlone);
}

} // namespace
} // namespace autostereo::test
