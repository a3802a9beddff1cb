#pragma once

#include <cstdint>

namespace autostereo::devices::sim {

/// Counter-based random numbers: every value is a pure function of its counters, so a frame can
/// be made again without those before it. The mixer is the finaliser of splitmix64.
[[nodiscard]] constexpr std::uint64_t mixBits(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31);
}

/// The `counter`-th value of stream `key`.
[[nodiscard]] constexpr std::uint64_t hashBits(std::uint64_t key, std::uint64_t counter) {
    return mixBits(key + (counter + 1) * 0x9e3779b97f4a7c15U);
}

/// Uniform in [0, 1), from the upper bits.
[[nodiscard]] constexpr double uniformFrom(std::uint64_t bits) {
    return static_cast<double>(bits >> 11) * 0x1p-53;
}

/// About normal, mean 0, sigma 1: the sum of the eight bytes (Irwin-Hall; excess kurtosis -0.15,
/// never beyond 4.9), because one multiplication adds them all.
[[nodiscard]] constexpr float gaussianFrom(std::uint64_t bits) {
    constexpr std::uint64_t kEven = 0x00ff00ff00ff00ffU;
    const std::uint64_t pairs = (bits & kEven) + ((bits >> 8) & kEven);
    const auto sum = static_cast<int>((pairs * 0x0001000100010001U) >> 48);
    constexpr float kSigma = 209.0207F; // sqrt(8 (256^2 - 1) / 12)
    return static_cast<float>(sum - 1020) * (1.0F / kSigma);
}

} // namespace autostereo::devices::sim
