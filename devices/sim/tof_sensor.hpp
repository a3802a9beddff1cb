#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace autostereo::devices::sim {

/// What one pixel would measure without noise.
struct TofSample {
    float depthM = 0;    ///< along the optical axis; 0: the pixel has no ray
    float amplitude = 0; ///< expected IR amplitude, counts
};

/// Returning light in counts of a surface that far along the ray.
[[nodiscard]] float tofAmplitude(double irReflectance, double cosine, double distanceM);

/// Standard deviation of one depth measurement, metres: a floor (jitter of the modulation) and a
/// part inverse to the amplitude, so growing as distance^2 / reflectance. A wall with reflectance
/// 0.7: 2.0 mm at 1 m, 8.0 mm at 3 m.
[[nodiscard]] double tofSigmaM(double amplitude);

/// A time-of-flight sensor: turns the exact picture into what such a camera delivers, in
/// millimetres and amplitude counts.
///  - gaussian noise after tofSigmaM; a fifth of each frame's noise is left over from the one
///  before;
///  - flying pixels: at depth edges the pixel's footprint reaches over to its neighbours; its
///    sub-rays are averaged with their amplitudes as weights;
///  - saturated (above kSaturation: depth 0, amplitude 65535), no return (below kLeast: depth 0).
/// With `noise` off: exact depth, rounded, and the expected amplitude.
/// A frame is a pure function of (seed, frame number, picture). Reentrant.
class TofSensor {
  public:
    static constexpr float kSaturation = 20000;
    static constexpr float kLeast = 35;

    TofSensor(int width, int height, std::uint64_t seed, bool noise);

    /// All three spans have width * height elements.
    void measure(std::span<const TofSample> exact, std::uint64_t frame,
                 std::span<std::uint16_t> depthMm, std::span<std::uint16_t> amplitude) const;

  private:
    void measureNoisy(std::span<const TofSample> exact, std::uint64_t frame,
                      std::span<std::uint16_t> depthMm, std::span<std::uint16_t> amplitude) const;
    [[nodiscard]] TofSample overFootprint(std::span<const TofSample> exact, std::size_t x,
                                          std::size_t y, std::uint64_t bits) const;

    std::size_t width_;
    std::size_t height_;
    std::uint64_t seed_;
    bool noise_;
};

} // namespace autostereo::devices::sim
