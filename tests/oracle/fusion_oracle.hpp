#pragma once

#include "gpu/scene_geometry.hpp"
#include "tests/oracle/view_oracle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

// Slow, obvious, double-precision twin of the fusion passes: depth measured on the cyclopean grid
// and the colour picture -> complete depth, what is hidden behind it, and the colours of that.

namespace autostereo::oracle {

/// One value a texel; outside: T{}.
template<class T>
struct Grid {
    int columns = 0, rows = 0;
    std::vector<T> texels;

    Grid(int width, int height)
        : columns(width), rows(height),
          texels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}
    [[nodiscard]] bool has(int x, int y) const {
        return x >= 0 && y >= 0 && x < columns && y < rows;
    }
    [[nodiscard]] T& at(int x, int y) {
        return texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) +
                      static_cast<std::size_t>(x)];
    }
    [[nodiscard]] T at(int x, int y) const {
        return has(x, y) ? texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) +
                                  static_cast<std::size_t>(x)]
                         : T{};
    }
    template<class Function> // (x, y) -> T
    static Grid of(int width, int height, Function value) {
        Grid grid(width, height);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                grid.at(x, y) = value(x, y);
        return grid;
    }
};

using DepthGrid = Grid<double>; ///< metres; 0: none

/// What the fusion is told beside its depth, lengths in texels.
struct FusionInput {
    calib::SensorRig rig;
    gpu::SceneGeometry geometry;
    double cutRatio = 0.05;
    int fillReach = 128, edgeReach = 6, unsure = 3, band = 2;
    Picture color; ///< levels 0..255
};

inline bool behind(const FusionInput& in, double z, double nearer) {
    return z > nearer * (1 + in.cutRatio);
}
inline bool oneSurface(const FusionInput& in, double a, double b) {
    return !behind(in, a, b) && !behind(in, b, a);
}

/// Pixel of the colour picture that shows a texel; nothing where it shows none.
inline std::optional<glm::dvec2> sourceOf(const FusionInput& in, double x, double y) {
    const glm::dvec2 ray =
        in.geometry.framing.rayFromPanel(in.geometry.grid.panelFromTexel({x, y}));
    const auto pixel = in.rig.color.project({ray, 1});
    if (!pixel || pixel->x < -0.5 || pixel->y < -0.5 || pixel->x > in.color.width - 0.5 ||
        pixel->y > in.color.height - 0.5)
        return std::nullopt;
    return pixel;
}

inline std::array<double, 3> colorOf(const FusionInput& in, int x, int y) {
    const auto pixel = sourceOf(in, x, y);
    std::array<double, 3> color{};
    if (pixel) color = in.color.sample(pixel->x, pixel->y);
    for (double& channel : color)
        channel /= 255;
    return color;
}

inline DepthGrid sureDepth(const FusionInput& in, const DepthGrid& measured) {
    return DepthGrid::of(measured.columns, measured.rows, [&](int x, int y) {
        const double z = measured.at(x, y);
        for (int j = y - in.band; j <= y + in.band; ++j)
            for (int i = x - in.band; i <= x + in.band; ++i) {
                const double other = measured.at(i, j);
                if (z > 0 && other > 0 && !oneSurface(in, z, other)) return 0.0;
            }
        return z;
    });
}

struct Neighbour {
    double z = 0;
    int steps = 0;
};

/// The first texel each way along row and column that has sure depth.
inline std::vector<Neighbour> neighbours(const FusionInput& in, const DepthGrid& sure, int x,
                                         int y) {
    std::vector<Neighbour> found;
    for (const auto& [dx, dy] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}})
        for (int steps = 1; steps <= in.fillReach; ++steps) {
            const int i = x + dx * steps, j = y + dy * steps;
            if (!sure.has(i, j)) break;
            if (sure.at(i, j) == 0) continue;
            found.push_back({sure.at(i, j), steps});
            break;
        }
    return found;
}

/// Of the first three measurements each way within reach: the nearest whose colour is alike, else
/// the one whose colour is most alike; the first one found of equals.
inline double surfaceByColor(const FusionInput& in, const DepthGrid& measured, int x, int y,
                             double otherwise) {
    struct Sample {
        double z = 0, off = 0;
    };
    std::vector<Sample> samples;
    const auto own = colorOf(in, x, y);
    for (const auto& [dx, dy] :
         {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}, {-1, -1}, {1, 1}, {1, -1}, {-1, 1}})
        for (int steps = 1, seen = 0; steps <= in.edgeReach && seen < 3; ++steps) {
            const int i = x + dx * steps, j = y + dy * steps;
            if (!measured.has(i, j)) break;
            if (measured.at(i, j) == 0) continue;
            ++seen;
            const auto color = colorOf(in, i, j);
            double off = 0;
            for (std::size_t c = 0; c < 3; ++c)
                off += (own[c] - color[c]) * (own[c] - color[c]);
            samples.push_back({measured.at(i, j), off});
        }
    if (samples.empty()) return otherwise;
    const double like = in.band > 0 ? 0.08 : 0.005;
    const auto isAlike = [&](const Sample& sample) { return sample.off < like; };
    if (std::ranges::none_of(samples, isAlike))
        return std::ranges::min_element(samples, {}, &Sample::off)->z;
    std::erase_if(samples, [&](const Sample& sample) { return !isAlike(sample); });
    return std::ranges::min_element(samples, {}, &Sample::z)->z;
}

inline double filled(const FusionInput& in, const DepthGrid& measured, int x, int y,
                     const std::vector<Neighbour>& found) {
    double nearest = 1e30, farthest = 0;
    bool alone = measured.at(x, y) > 0;
    for (const Neighbour& n : found) {
        if (n.steps <= in.edgeReach && oneSurface(in, n.z, measured.at(x, y))) alone = false;
        nearest = std::fmin(nearest, n.z);
        farthest = std::fmax(farthest, n.z);
    }
    if (alone || found.empty()) return measured.at(x, y);
    const double chosen =
        behind(in, farthest, nearest) ? surfaceByColor(in, measured, x, y, farthest) : farthest;
    double sum = 0, weights = 0;
    for (const Neighbour& n : found) {
        if (!oneSurface(in, n.z, chosen)) continue;
        sum += 1.0 / n.steps / n.z;
        weights += 1.0 / n.steps;
    }
    return weights > 0 ? weights / sum : chosen;
}

inline DepthGrid filledDepth(const FusionInput& in, const DepthGrid& measured,
                             const DepthGrid& sure) {
    return DepthGrid::of(sure.columns, sure.rows, [&](int x, int y) {
        if (!sourceOf(in, x, y)) return 0.0;
        if (sure.at(x, y) > 0) return sure.at(x, y);
        return filled(in, measured, x, y, neighbours(in, sure, x, y));
    });
}

struct Claim {
    double z = 0; ///< of the surface that a view sees behind the texel; 0: none does
    double distance = 1e9;
};

/// Texel by texel from one side of a row to the other: what the last step down hides.
inline void claimRow(const FusionInput& in, const DepthGrid& depth, int y, bool fromRight,
                     Grid<Claim>& claims) {
    const double texelsPerPanel = in.geometry.grid.columns / (1 + 2 * in.geometry.grid.marginU);
    const auto d = [&](double z) { return disparity(in.geometry.law, z); };
    double last = 0, hidden = 0;
    int edge = 0, lastX = 0;
    for (int i = 0; i < depth.columns; ++i) {
        const int x = fromRight ? depth.columns - 1 - i : i;
        const double z = depth.at(x, y);
        Claim claim;
        if (z == 0) {
            if (last > 0) claim = {last, std::abs(x - lastX) * 1.0};
        } else {
            if (last > 0 && behind(in, last, z)) std::tie(hidden, edge) = std::pair{last, x};
            if (hidden > 0 && !behind(in, hidden, z)) hidden = 0;
            if (hidden > 0 && std::abs(x - edge) < (d(z) - d(hidden)) * texelsPerPanel + 1)
                claim = {hidden, std::abs(x - edge) * 1.0};
            std::tie(last, lastX) = std::pair{z, x};
        }
        if (claim.z == 0) continue;
        Claim& kept = claims.at(x, y);
        const bool better = kept.z == 0 || claim.distance < kept.distance ||
                            (claim.distance == kept.distance && claim.z > kept.z);
        if (better) kept = claim;
    }
}

inline Grid<Claim> claimsOf(const FusionInput& in, const DepthGrid& depth) {
    Grid<Claim> claims(depth.columns, depth.rows);
    for (int y = 0; y < depth.rows; ++y)
        for (const bool fromRight : {false, true})
            claimRow(in, depth, y, fromRight, claims);
    return claims;
}

/// Premultiplied values and, last, their weight.
using Weighted = std::array<double, 4>;

/// What is spread comes in these steps, so that what changes far off changes nothing.
inline double inSteps(double value) { return std::nearbyint(value * 4096) / 4096; }

/// Values everywhere from weighted seeds, by a pyramid of binomial means; on so many levels a fifth
/// of the weight is as good as all. `mean`: of the coarsest level.
inline Grid<Weighted> pullPush(Grid<Weighted> fine, int sharpLevels, Weighted& mean) {
    const Grid<Weighted>& seeds = fine; // nothing lies outside it
    if (fine.columns > 1 || fine.rows > 1) {
        constexpr std::array<double, 4> kWeights{0.125, 0.375, 0.375, 0.125};
        const auto coarse = pullPush(
            Grid<Weighted>::of((fine.columns + 1) / 2, (fine.rows + 1) / 2,
                               [&](int x, int y) {
                                   Weighted sum{};
                                   for (int j = 0; j < 4; ++j)
                                       for (int i = 0; i < 4; ++i)
                                           for (std::size_t k = 0; k < 4; ++k)
                                               sum[k] += kWeights[static_cast<std::size_t>(i)] *
                                                         kWeights[static_cast<std::size_t>(j)] *
                                                         seeds.at(2 * x + i - 1, 2 * y + j - 1)[k];
                                   const double gain =
                                       sharpLevels > 0 && sum[3] > 0 ? std::fmin(1 / sum[3], 5) : 1;
                                   for (double& part : sum)
                                       part *= gain;
                                   return sum;
                               }),
            sharpLevels - 1, mean);
        const auto clamped = [&](int x, int y) {
            return coarse.at(std::clamp(x, 0, coarse.columns - 1),
                             std::clamp(y, 0, coarse.rows - 1));
        };
        for (int y = 0; y < fine.rows; ++y)
            for (int x = 0; x < fine.columns; ++x) {
                const double cx = (x + 0.5) / 2 - 0.5, cy = (y + 0.5) / 2 - 0.5;
                const int i = static_cast<int>(std::floor(cx)),
                          j = static_cast<int>(std::floor(cy));
                const double p = cx - i, q = cy - j;
                Weighted& own = fine.at(x, y);
                const double lacking = 1 - own[3];
                for (std::size_t k = 0; k < 4; ++k)
                    own[k] = inSteps(
                        own[k] +
                        lacking *
                            ((1 - q) * ((1 - p) * clamped(i, j)[k] + p * clamped(i + 1, j)[k]) +
                             q * ((1 - p) * clamped(i, j + 1)[k] + p * clamped(i + 1, j + 1)[k])));
            }
        return fine;
    }
    Weighted& only = fine.at(0, 0);
    const double weight = only[3];
    for (std::size_t k = 0; k < 4; ++k)
        only[k] = weight > 0 ? inSteps(only[k] / weight) : 0;
    mean = only;
    return fine;
}

struct Background {
    DepthGrid depth;
    Grid<std::array<double, 3>> color; ///< 0..1
};

inline bool besideNearer(const FusionInput& in, const DepthGrid& depth, int x, int y) {
    const auto clamped = [&](int i, int j) {
        return depth.at(std::clamp(i, 0, depth.columns - 1), std::clamp(j, 0, depth.rows - 1));
    };
    for (int step = 1; step <= in.unsure; ++step)
        for (const double other : {clamped(x - step, y), clamped(x + step, y), clamped(x, y - step),
                                   clamped(x, y + step)})
            if (other > 0 && behind(in, depth.at(x, y), other)) return true;
    return false;
}

inline Background background(const FusionInput& in, const DepthGrid& sure, const DepthGrid& depth,
                             const Grid<Claim>& claims) {
    const int columns = depth.columns, rows = depth.rows;
    constexpr int kAllLevels = 32, kNarrowLevels = 2;
    Weighted mean{}, unused{};
    const auto guide =
        pullPush(Grid<Weighted>::of(columns, rows,
                                    [&](int x, int y) {
                                        const double z = claims.at(x, y).z;
                                        return z > 0 ? Weighted{1 / z, 0, 0, 1} : Weighted{};
                                    }),
                 kAllLevels, mean);
    const auto spread = pullPush(
        Grid<Weighted>::of(
            columns, rows,
            [&](int x, int y) {
                const double z = depth.at(x, y), inverse = guide.at(x, y)[0];
                const bool far = z > 0 && !(inverse > 0 && behind(in, 1 / inverse, z));
                const bool guessed = sure.at(x, y) == 0;
                if (!far || claims.at(x, y).z > 0 || !sourceOf(in, x, y) ||
                    (guessed && besideNearer(in, depth, x, y)))
                    return Weighted{};
                const auto color = colorOf(in, x, y);
                const double weight = std::clamp(std::pow(z * mean[0], 20), 0.02, 1.0);
                return Weighted{weight * color[0], weight * color[1], weight * color[2], weight};
            }),
        kNarrowLevels, unused);
    Background result{DepthGrid(columns, rows), {columns, rows}};
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) {
            const double claimed = claims.at(x, y).z, inverse = guide.at(x, y)[0];
            const auto& hidden = spread.at(x, y);
            const double z = depth.at(x, y);
            const double guessed = inverse > 0 ? 1 / inverse : in.geometry.law.focusM;
            result.depth.at(x, y) = claimed > 0 ? claimed : z > 0 ? z : guessed;
            const bool own = sourceOf(in, x, y) && (z == 0 || claimed == 0);
            result.color.at(x, y) =
                own ? colorOf(in, x, y) : std::array{hidden[0], hidden[1], hidden[2]};
        }
    return result;
}

} // namespace autostereo::oracle
