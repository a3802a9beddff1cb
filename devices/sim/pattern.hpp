#pragma once

#include "devices/sim/hash.hpp"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace autostereo::devices::sim {

/// Band-limited building blocks of the textures: soft edges and smooth noise.

/// 0 below -soft, 1 above soft, smooth between.
[[nodiscard]] inline double softStep(double x, double soft) {
    const double t = std::clamp((x + soft) / (2 * soft), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

/// 1 inside |x| < half, with soft edges.
[[nodiscard]] inline double softBand(double x, double half, double soft) {
    return softStep(half - std::abs(x), soft);
}

/// 1 inside the ellipse around `centre`.
[[nodiscard]] inline double softDisc(glm::dvec2 p, glm::dvec2 centre, glm::dvec2 radius) {
    return softStep(1 - glm::length((p - centre) / radius), 0.08);
}

/// Distance to the nearest multiple of `period`.
[[nodiscard]] inline double toGrid(double x, double period) {
    return std::abs(x - period * std::round(x / period));
}

/// Constant in [0, 1) for each cell of a lattice.
[[nodiscard]] inline double cellValue(double column, double row, std::uint32_t seed) {
    const auto x = static_cast<std::uint32_t>(static_cast<std::int64_t>(column));
    const auto y = static_cast<std::uint32_t>(static_cast<std::int64_t>(row));
    return uniformFrom(hashBits(seed, (std::uint64_t{x} << 32) | y));
}

/// Smooth in [0, 1], features of about one unit.
[[nodiscard]] inline double valueNoise(glm::dvec2 p, std::uint32_t seed) {
    const double column = std::floor(p.x), row = std::floor(p.y);
    const double x = p.x - column, y = p.y - row;
    const double u = x * x * (3 - 2 * x), v = y * y * (3 - 2 * y);
    const auto along = [&](double r) {
        const double left = cellValue(column, r, seed);
        return left + (cellValue(column + 1, r, seed) - left) * u;
    };
    const double top = along(row);
    return top + (along(row + 1) - top) * v;
}

} // namespace autostereo::devices::sim
