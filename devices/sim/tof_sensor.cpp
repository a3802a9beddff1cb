#include "devices/sim/tof_sensor.hpp"

#include "devices/sim/hash.hpp"

#include <algorithm>
#include <cmath>

namespace autostereo::devices::sim {
namespace {

constexpr float kAmplitudeAtOneMetre = 5000; // reflectance 1, facing the camera
constexpr float kSigmaFloorMm = 1.80F;
constexpr float kSigmaMmCounts = 3032; // sigma of 1 mm per this many counts, inverse
constexpr float kFromFrameBefore = 0.20F;
constexpr float kFromThisFrame = 0.979796F; // so that both together keep the variance

float sigmaMm(float amplitude) {
    const float shot = kSigmaMmCounts / std::max(amplitude, 1.0F);
    return std::sqrt(kSigmaFloorMm * kSigmaFloorMm + shot * shot);
}

/// Neighbours further apart than this part of their depth lie on different surfaces.
constexpr float kEdgeStep = 0.04F;
constexpr std::uint16_t kSaturatedCount = 65535;

std::uint16_t roundedCount(float value) {
    constexpr float kMost = kSaturatedCount - 1;
    // Never negative; lround is a library call, too slow for every pixel.
    // NOLINTNEXTLINE(bugprone-incorrect-roundings)
    return static_cast<std::uint16_t>(std::clamp(value, 0.0F, kMost) + 0.5F);
}

} // namespace

float tofAmplitude(double irReflectance, double cosine, double distanceM) {
    return static_cast<float>(kAmplitudeAtOneMetre * irReflectance * cosine /
                              (distanceM * distanceM));
}

double tofSigmaM(double amplitude) {
    return static_cast<double>(sigmaMm(static_cast<float>(amplitude))) * 1e-3;
}

TofSensor::TofSensor(int width, int height, std::uint64_t seed, bool noise)
    : width_(static_cast<std::size_t>(width)), height_(static_cast<std::size_t>(height)),
      seed_(seed), noise_(noise) {}

void TofSensor::measure(std::span<const TofSample> exact, std::uint64_t frame,
                        std::span<std::uint16_t> depthMm,
                        std::span<std::uint16_t> amplitude) const {
    if (noise_) return measureNoisy(exact, frame, depthMm, amplitude);
    for (std::size_t pixel = 0; pixel < exact.size(); ++pixel) {
        depthMm[pixel] = roundedCount(exact[pixel].depthM * 1000);
        amplitude[pixel] = roundedCount(exact[pixel].amplitude);
    }
}

/// Each of four sub-rays, towards the four neighbours, falls on the neighbour's surface one time
/// in four, else on the pixel's own. Only what lies across a depth edge counts.
TofSample TofSensor::overFootprint(std::span<const TofSample> exact, std::size_t x, std::size_t y,
                                   std::uint64_t bits) const {
    const std::size_t pixel = y * width_ + x;
    const TofSample& own = exact[pixel];
    const TofSample* const around[] = {
        x > 0 ? &exact[pixel - 1] : &own, x + 1 < width_ ? &exact[pixel + 1] : &own,
        y > 0 ? &exact[pixel - width_] : &own, y + 1 < height_ ? &exact[pixel + width_] : &own};
    const float step = kEdgeStep * own.depthM;
    float weight = 0, weightedDepth = 0;
    for (const TofSample* neighbour : around) {
        const bool strays = std::abs(neighbour->depthM - own.depthM) > step &&
                            neighbour->depthM > 0 && (bits & 3U) == 0;
        bits >>= 2;
        const TofSample& seen = strays ? *neighbour : own;
        weight += seen.amplitude;
        weightedDepth += seen.amplitude * seen.depthM;
    }
    return weight > 0 ? TofSample{weightedDepth / weight, weight / 4} : own;
}

void TofSensor::measureNoisy(std::span<const TofSample> exact, std::uint64_t frame,
                             std::span<std::uint16_t> depthMm,
                             std::span<std::uint16_t> amplitude) const {
    // Streams of random numbers: one per frame for depth, one for all else.
    const auto key = [&](std::uint64_t of, std::uint64_t what) {
        return hashBits(hashBits(seed_, of), what);
    };
    const std::uint64_t now = key(frame, 0), before = key(frame - 1, 0), other = key(frame, 1);
    for (std::size_t y = 0; y < height_; ++y) {
        for (std::size_t x = 0; x < width_; ++x) {
            const std::size_t pixel = y * width_ + x;
            depthMm[pixel] = 0;
            amplitude[pixel] = 0;
            if (!(exact[pixel].depthM > 0)) continue;
            const std::uint64_t bits = hashBits(other, pixel);
            const TofSample seen = overFootprint(exact, x, y, bits);
            const float readNoise = 2 + 0.5F * std::sqrt(seen.amplitude); // and shot noise
            const float counts = seen.amplitude + readNoise * gaussianFrom(mixBits(bits));
            amplitude[pixel] = counts > kSaturation ? kSaturatedCount : roundedCount(counts);
            if (counts > kSaturation || counts < kLeast) continue;
            const float noise = kFromThisFrame * gaussianFrom(hashBits(now, pixel)) +
                                kFromFrameBefore * gaussianFrom(hashBits(before, pixel));
            depthMm[pixel] = roundedCount(seen.depthM * 1000 + sigmaMm(seen.amplitude) * noise);
        }
    }
}

} // namespace autostereo::devices::sim
