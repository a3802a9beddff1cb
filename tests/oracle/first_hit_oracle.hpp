#pragma once

#include "calib/view_map.hpp"
#include "gpu/scene_geometry.hpp"
#include "tests/oracle/fusion_oracle.hpp"

// Slow, obvious, double-precision twin of the search: every piece of a row is tried, and the
// nearest one that the ray enters from the front is what the eye sees.

namespace autostereo::oracle {

/// Disparities of a texel's corners: top left, top right, bottom left, bottom right.
using Quad = std::array<double, 4>;

struct SearchInput {
    calib::SensorRig rig;
    gpu::SceneGeometry geometry;
    Grid<Quad> scene, background;
    Picture color, backgroundColor; ///< levels 0..255
};

constexpr double kLargest = 0.4; ///< disparity of any display, panel widths

inline bool isSolid(const Quad& quad) { return quad[0] > -1e8; }

/// Where in texels a ray x + reach d first enters the layer's row from the front.
inline std::optional<double> firstHit(const Grid<Quad>& layer, int row, double down, double x,
                                      double reach) {
    const double way = reach >= 0 ? 1 : -1;
    const auto inFront = [&](double u, double d) { return way * (u - x) - std::abs(reach) * d; };
    std::optional<double> nearest;
    // What lies farther away than the largest disparity cannot be on the ray.
    const int first = std::max(0, static_cast<int>(x - std::abs(reach) * kLargest) - 1);
    const int last =
        std::min(layer.columns - 1, static_cast<int>(x + std::abs(reach) * kLargest) + 1);
    for (int cell = first; cell <= last; ++cell) {
        const Quad q = layer.at(cell, row);
        if (!isSolid(q)) continue;
        const auto along = [&](int a, int b) {
            const double above = q[static_cast<std::size_t>(a)];
            return above + (q[static_cast<std::size_t>(b)] - above) * down;
        };
        const std::array<std::array<double, 2>, 3> ends{
            {{cell + 0.0, along(0, 2)}, {cell + 1 - down, along(1, 2)}, {cell + 1.0, along(1, 3)}}};
        for (std::size_t piece = 0; piece < 2; ++piece) {
            const auto& [entryAt, entry] = ends[way > 0 ? piece + 1 : piece];
            const auto& [exitAt, exit] = ends[way > 0 ? piece : piece + 1];
            const double above = inFront(entryAt, entry), below = inFront(exitAt, exit);
            if (!(above > 0 && below <= 0)) continue;
            const double hit = entryAt + (exitAt - entryAt) * above / (above - below);
            if (!nearest || way * hit > way * *nearest) nearest = hit;
        }
    }
    return nearest;
}

/// What an eye at position b sees at (x, v) of the panel (panel widths and heights, y up).
inline std::array<double, 3> searchedColor(const SearchInput& in, double b, double x, double v) {
    const calib::CyclopeanGrid& grid = in.geometry.grid;
    const double texels = grid.columns / (1 + 2 * grid.marginU);
    const double place = (x + grid.marginU) * texels;
    const double y = (1 + grid.marginV - v) / (1 + 2 * grid.marginV) * grid.rows;
    const int row = std::clamp(static_cast<int>(y), 0, grid.rows - 1);
    if (const auto hit = firstHit(in.scene, row, y - row, place, b * texels)) {
        const glm::dvec2 ray = in.geometry.framing.rayFromPanel({*hit / texels - grid.marginU, v});
        const auto pixel = in.rig.color.project({ray, 1});
        if (pixel) return in.color.sample(pixel->x, pixel->y);
        return in.color.sample(-1, -1); // as the GPU's clamped (-1, -1)
    }
    const auto behind = firstHit(in.background, row, y - row, place, b * texels);
    return in.backgroundColor.sample(
        behind.value_or(place + b * texels * in.geometry.law.farthest) - 0.5, y - 0.5);
}

} // namespace autostereo::oracle
