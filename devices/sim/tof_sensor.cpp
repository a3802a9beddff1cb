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

/// Neighbours further apart than this lie on different surfaces.
float edgeStep(float depthM) { return 0.04F * depthM; }

std::uint16_t roundedCount(float value, float most) {
    return static_cast<std::uint16_t>(std::lround(std::clamp(value, 0.0F, most)));
}

constexpr float kMostCount = 65534; // 65535 means saturated (amplitude), nothing (depth)

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
        depthMm[pixel] = roundedCount(exact[pixel].depthM * 1000, kMostCount);
        amplitude[pixel] = roundedCount(exact[pixel].amplitude, kMostCount);
    }
}

/// Each of four sub-rays, towards the four neighbours, falls on the neighbour's surface one time
/// in four, else on the pixel's own. Only what lies across a depth edge counts.
TofSample TofSensor::overFootprint(std::span<const TofSample> exact, std::size_t pixel,
                                   std::uint64_t bits) const {
    const TofSample own = exact[pixel];
    const std::size_t x = pixel % width_, y = pixel / width_;
    const float step = edgeStep(own.depthM);
    float weight = 0, weightedDepth = 0;
    const auto subRay = [&](bool inside, std::size_t neighbour) {
        TofSample seen = own;
        const bool strays = (bits & 3U) == 0;
        bits >>= 2;
        if (inside && strays && exact[neighbour].depthM > 0 &&
            std::abs(exact[neighbour].depthM - own.depthM) > step) {
            seen = exact[neighbour];
        }
        weight += seen.amplitude;
        weightedDepth += seen.amplitude * seen.depthM;
    };
    subRay(x > 0, pixel - 1);
    subRay(x + 1 < width_, pixel + 1);
    subRay(y > 0, pixel - width_);
    subRay(y + 1 < height_, pixel + width_);
    if (!(weight > 0)) return own;
    return {weightedDepth / weight, weight / 4};
}

void TofSensor::measureNoisy(std::span<const TofSample> exact, std::uint64_t frame,
                             std::span<std::uint16_t> depthMm,
                             std::span<std::uint16_t> amplitude) const {
    // Streams of random numbers: one per frame for depth, one for all else.
    const auto key = [&](std::uint64_t of, std::uint64_t what) {
        return hashBits(hashBits(seed_, of), what);
    };
    const std::uint64_t now = key(frame, 0), before = key(frame - 1, 0), other = key(frame, 1);
    for (std::size_t pixel = 0; pixel < exact.size(); ++pixel) {
        depthMm[pixel] = 0;
        amplitude[pixel] = 0;
        if (!(exact[pixel].depthM > 0)) continue;
        const std::uint64_t bits = hashBits(other, pixel);
        const TofSample seen = overFootprint(exact, pixel, bits);
        // Shot and read noise of the amplitude; the mixing bits above are the lowest byte.
        const float read = 2 + 0.5F * std::sqrt(seen.amplitude);
        const float counts = seen.amplitude + read * gaussianFrom(mixBits(bits));
        if (counts > kSaturation) {
            amplitude[pixel] = 65535;
            continue;
        }
        amplitude[pixel] = roundedCount(counts, kMostCount);
        if (counts < kLeast) continue;
        const float noise = kFromThisFrame * gaussianFrom(hashBits(now, pixel)) +
                            kFromFrameBefore * gaussianFrom(hashBits(before, pixel));
        depthMm[pixel] =
            roundedCount(seen.depthM * 1000 + sigmaMm(seen.amplitude) * noise, kMostCount);
    }
}

} // namespace autostereo::devices::sim
