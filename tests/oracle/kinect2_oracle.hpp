#pragma once

#include "devices/kinect2/depth_packets.hpp"
#include "tests/support/kinect2_unit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

// Slow, obvious, double-precision twin of the Kinect v2 decoder, pixel by pixel and bit by bit, and
// the unwrapping of the reference driver (libfreenect2) with its constants meant as published.

namespace autostereo::oracle {

/// The companded sample of one sub-image; nothing where overexposed.
inline std::optional<double> sampleAt(const devices::kinect2::RawDepthFrame& frame,
                                      std::size_t subImage, int x, int y) {
    const auto bytes = frame.subImage(subImage);
    const int row = y < 212 ? y : 635 - y;
    unsigned code = 0;
    for (int bit = 0; bit < 11; ++bit) {
        const int at = ((x >> 2) + 128 * (x & 3)) * 11 + bit;
        const auto byte =
            std::to_integer<unsigned>(bytes[static_cast<std::size_t>(row * 704 + at / 8)]);
        code |= (byte >> static_cast<unsigned>(at % 8) & 1U) << static_cast<unsigned>(bit);
    }
    static const std::vector<double> kMagnitudes = [] {
        std::vector<double> table{0};
        for (int i = 0; i < 1023; ++i)
            table.push_back(table.back() + (i < 128 ? 1 : std::pow(2, i / 128 - 1)));
        return table;
    }();
    if (code == 1024) return std::nullopt;
    return code > 1024 ? -kMagnitudes[code - 1024] : kMagnitudes[code];
}

/// One pixel's light.
struct Phases {
    std::array<double, 3> turns{};
    std::array<double, 3> amplitudes{};
};

inline std::optional<Phases> phasesAt(const devices::kinect2::RawDepthFrame& frame,
                                      const test::Kinect2Unit& unit, int x, int y) {
    constexpr double kPi = std::numbers::pi;
    Phases result;
    for (std::size_t f = 0; f < 3; ++f) {
        const double p0 = -unit.offsets[f][static_cast<std::size_t>(y * 512 + x)] * kPi / 32768;
        double a = 0, b = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto sample = sampleAt(frame, 3 * f + i, x, y);
            if (!sample) return std::nullopt;
            const double shift = 2 * kPi * static_cast<double>(i) / 3;
            a += *sample * std::cos(p0 + shift);
            b -= *sample * std::sin(p0 + shift);
        }
        const double turns = std::atan2(b, a) / (2 * kPi);
        result.turns[f] = turns - std::floor(turns);
        result.amplitudes[f] = std::hypot(a, b) * 2 / 3 * unit.multipliers[f] / unit.multipliers[1];
    }
    return result;
}

/// The light's path in units of 1250 mm by trying each of 10 x 2 x 15 combinations of wraps: the
/// one whose paths differ least, weighted as their noise demands; and its sum of weighted squares.
struct Fit {
    double path = 0;
    double misfit = std::numeric_limits<double>::infinity();
};
inline Fit bestFit(const Phases& phases, const test::Kinect2Unit& unit) {
    constexpr std::array<double, 3> kPeriods{3, 15, 2};
    std::array<double, 3> weights{};
    for (std::size_t f = 0; f < 3; ++f)
        weights[f] = std::pow(unit.multipliers[1] / (kPeriods[f] * unit.multipliers[f]), 2);
    const double sum = weights[0] + weights[1] + weights[2];
    Fit best;
    for (int k0 = 0; k0 < 10; ++k0)
        for (int k1 = 0; k1 < 2; ++k1)
            for (int k2 = 0; k2 < 15; ++k2) {
                const std::array<double, 3> paths{3 * (phases.turns[0] + k0),
                                                  15 * (phases.turns[1] + k1),
                                                  2 * (phases.turns[2] + k2)};
                double mean = 0, misfit = 0;
                for (std::size_t f = 0; f < 3; ++f)
                    mean += weights[f] * paths[f] / sum;
                for (std::size_t f = 0; f < 3; ++f)
                    misfit += weights[f] * std::pow(paths[f] - mean, 2);
                if (misfit < best.misfit) best = {mean, misfit};
            }
    return best;
}

/// Depth at which laser, surface and lens make a path that long, by bisection.
inline double depthOf(const std::array<double, 2>& ray, double pathMm) {
    double near = 0, far = pathMm;
    for (int i = 0; i < 100; ++i) {
        const double z = (near + far) / 2;
        const double there = std::hypot(ray[0] * z - 45, ray[1] * z, z);
        const double back = std::hypot(ray[0] * z, ray[1] * z, z);
        (there + back < pathMm ? near : far) = z;
    }
    return (near + far) / 2;
}

/// What the reference driver makes of the same phases: path, and whether it lets it pass.
struct ReferenceUnwrapping {
    double path = 0;
    bool accepted = false;
};
inline ReferenceUnwrapping referenceUnwrapping(const Phases& phases) {
    const double t0 = phases.turns[0] * 3, t1 = phases.turns[1] * 15, t2 = phases.turns[2] * 2;
    // 80 MHz by 16 MHz, then whether 16 MHz has to go once more round by 120 MHz.
    const double u0 = std::floor((t1 - t0) / 3 + 0.5) * 3 + t0;
    const double u0mod2 = u0 - std::floor(u0 / 2) * 2;
    const double apart = t2 - u0mod2;
    const double u1 = std::abs(apart) > 0.5 && std::abs(apart) < 1.5 ? t1 + 15 : t1;
    const double path0 = std::floor((u1 - t0) / 3 + 0.5) * 3 + t0;
    const double path2 = std::floor((path0 - t2) / 2 + 0.5) * 2 + t2;
    const double turn = 2 * std::numbers::pi;
    const double x = turn * path0 / 3, y = turn * u1 / 15, z = turn * path2 / 2;
    const double cx = y * 0.826977 - z * 0.110264, cy = z * 0.551318 - x * 0.826977,
                 cz = x * 0.110264 - y * 0.551318;
    const double most = *std::ranges::max_element(phases.amplitudes);
    const double least = *std::ranges::min_element(phases.amplitudes);
    const double limit =
        std::clamp(std::pow(10.0, 0.7694894 - 0.5330578 * std::log10(most)), 0.349, 0.611);
    const double sum = phases.amplitudes[0] + phases.amplitudes[1] + phases.amplitudes[2];
    return {(path0 / 3 + u1 / 15 + path2 / 2) / 0.9,
            least >= 3 && sum >= 10 && cx * cx + cy * cy + cz * cz <= limit * limit};
}

} // namespace autostereo::oracle
