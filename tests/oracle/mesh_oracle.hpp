#pragma once

#include "calib/sensor_rig.hpp"
#include "gpu/scene_geometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

// Slow, obvious, double-precision twin of DepthMesh: depth counts -> the two mesh layers.

namespace autostereo::oracle {

struct DepthPicture {
    int width = 0;
    int height = 0;
    double unitM = 0.001;
    std::vector<std::uint16_t> counts;

    [[nodiscard]] std::uint32_t at(int x, int y) const {
        return counts[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
};

struct Node {
    double u, v, d, z; ///< cyclopean picture, disparity, depth at the colour camera
    double s, t;       ///< texture coordinate in the colour image
    bool clean = true; ///< no nearer surface close beside it, as the colour camera sees it
};

struct Layer {
    int width = 0;
    int height = 0;
    std::vector<std::optional<Node>> nodes;
    std::vector<std::array<int, 3>> triangles; ///< node numbers

    [[nodiscard]] std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x);
    }
};

struct MeshInput {
    DepthPicture depth;
    calib::SensorRig rig;
    gpu::SceneGeometry geometry;
    gpu::DepthMeshParams params;
};

inline double disparity(const calib::DisparityLaw& law, double z) {
    const double height = law.scale * (law.focusM - z);
    if (height >= law.viewerDistanceM) return law.nearest;
    const double d = law.fanHalfWidth * height / (law.viewerDistanceM - height);
    return std::fmin(std::fmax(d, law.farthest), law.nearest);
}

inline bool measured(const MeshInput& in, std::uint32_t count) {
    const double z = count * in.depth.unitM;
    return count != 0 && count != 65535 && z >= in.params.nearestM - 1e-9 &&
           z <= in.params.farthestM + 1e-9;
}

inline bool cutBetween(const MeshInput& in, std::uint32_t nearer, std::uint32_t farther) {
    return (farther - nearer) * 1000.0 > std::round(in.params.cutRatio * 1000) * nearer;
}

/// The node whose position is pixel (x, y)'s ray at `count`, coloured by pixel (sx, sy).
inline std::optional<Node> node(const MeshInput& in, int x, int y, std::uint32_t count, int sx,
                                int sy) {
    const calib::CameraModel camera = in.rig.depth.resized(in.depth.width, in.depth.height);
    const double z = count * in.depth.unitM;
    const auto place = [&](int px, int py) -> std::optional<glm::dvec3> {
        const auto ray = camera.unproject({px, py});
        if (!ray) return std::nullopt;
        const glm::dvec3 p = in.rig.colorFromDepth * glm::dvec3{ray->x * z, ray->y * z, z};
        if (!(p.z > 0)) return std::nullopt;
        return p;
    };
    const auto point = place(x, y), seen = place(sx, sy);
    if (!point || !seen) return std::nullopt;
    const auto pixel = in.rig.color.project(*seen);
    if (!pixel) return std::nullopt;
    const calib::Framing& f = in.geometry.framing;
    return Node{(point->x / point->z - f.left) / f.width,
                (f.bottom - point->y / point->z) / f.height,
                disparity(in.geometry.law, point->z),
                point->z,
                (pixel->x + 0.5) / in.rig.color.intrinsics.width,
                (pixel->y + 0.5) / in.rig.color.intrinsics.height,
                true};
}

template<class Drawn>
void addTriangles(Layer& layer, Drawn drawn) {
    const auto add = [&](std::array<int, 3> corners) {
        for (const int corner : corners)
            if (!layer.nodes[static_cast<std::size_t>(corner)]) return;
        if (drawn(corners)) layer.triangles.push_back(corners);
    };
    for (int y = 0; y + 1 < layer.height; ++y)
        for (int x = 0; x + 1 < layer.width; ++x) {
            const int here = y * layer.width + x, below = here + layer.width;
            add({here, below, here + 1});
            add({here + 1, below, below + 1});
        }
}

inline void addSceneTriangles(const MeshInput& in, Layer& layer) {
    layer.triangles.clear();
    addTriangles(layer, [&](const std::array<int, 3>& corners) {
        std::uint32_t nearest = 65535, farthest = 0;
        for (const int corner : corners) {
            const std::uint32_t count = in.depth.counts[static_cast<std::size_t>(corner)];
            nearest = std::min(nearest, count);
            farthest = std::max(farthest, count);
        }
        return !cutBetween(in, nearest, farthest);
    });
}

/// Nearest depth at the colour camera on a picture of the depth grid's size; infinity: none.
inline std::vector<double> registeredDepth(const Layer& layer) {
    std::vector<double> nearest(layer.nodes.size(), std::numeric_limits<double>::infinity());
    for (const auto& corners : layer.triangles) {
        std::array<const Node*, 3> n{};
        for (std::size_t i = 0; i < 3; ++i)
            n[i] = &*layer.nodes[static_cast<std::size_t>(corners[i])];
        const auto x = [&](std::size_t i) { return n[i]->s * layer.width; };
        const auto y = [&](std::size_t i) { return n[i]->t * layer.height; };
        const double area = (x(1) - x(0)) * (y(2) - y(0)) - (x(2) - x(0)) * (y(1) - y(0));
        const auto [left, right] = std::minmax({x(0), x(1), x(2)});
        const auto [top, bottom] = std::minmax({y(0), y(1), y(2)});
        for (int j = std::max(0, static_cast<int>(top)); j < layer.height && j <= bottom; ++j)
            for (int i = std::max(0, static_cast<int>(left)); i < layer.width && i <= right; ++i) {
                double inverse = 0;
                bool inside = area != 0;
                for (std::size_t k = 0; k < 3 && inside; ++k) {
                    const std::size_t p = (k + 1) % 3, q = (k + 2) % 3;
                    const double weight = ((x(p) - i - 0.5) * (y(q) - j - 0.5) -
                                           (x(q) - i - 0.5) * (y(p) - j - 0.5)) /
                                          area;
                    inside = weight >= 0;
                    inverse += weight / n[k]->z;
                }
                double& best = nearest[layer.at(i, j)];
                if (inside) best = std::min(best, 1 / inverse);
            }
    }
    return nearest;
}

/// Nodes that the colour camera cannot see go; those within 3 pixels of a nearer one are not clean.
inline void hideFromColor(const MeshInput& in, Layer& layer) {
    const std::vector<double> nearest = registeredDepth(layer);
    for (auto& node : layer.nodes) {
        if (!node) continue;
        // Clamped first: a node far outside the picture must not overflow the integer.
        const int i = static_cast<int>(std::floor(std::clamp(node->s, -1.0, 2.0) * layer.width));
        const int j = static_cast<int>(std::floor(std::clamp(node->t, -1.0, 2.0) * layer.height));
        if (j < 0 || j >= layer.height) continue;
        const double z = node->z;
        for (int x = std::max(i - 3, 0); x <= std::min(i + 3, layer.width - 1); ++x) {
            const double front = nearest[layer.at(x, j)];
            const bool behind = z > front * (1 + in.params.cutRatio);
            if (behind && node) node->clean = false;
            if (behind && x == i) node.reset();
        }
    }
}

inline Layer sceneLayer(const MeshInput& in) {
    Layer layer{in.depth.width, in.depth.height, {}, {}};
    for (int y = 0; y < layer.height; ++y)
        for (int x = 0; x < layer.width; ++x) {
            const std::uint32_t count = in.depth.at(x, y);
            layer.nodes.push_back(measured(in, count) ? node(in, x, y, count, x, y) : std::nullopt);
        }
    addSceneTriangles(in, layer);
    hideFromColor(in, layer);
    addSceneTriangles(in, layer);
    return layer;
}

/// A depth sample that a background node may take: its count and the pixel that gives the colour.
struct Sample {
    std::uint32_t count = 0; ///< 0: none
    int x = 0, y = 0;
    bool measured = false; ///< something was, visible or hidden
};

inline Sample farthestAround(const MeshInput& in, const Layer& scene, int centerX, int centerY,
                             int stride) {
    Sample best;
    for (int y = centerY - stride; y <= centerY + stride; ++y)
        for (int x = centerX - stride; x <= centerX + stride; ++x) {
            if (x < 0 || y < 0 || x >= in.depth.width || y >= in.depth.height) continue;
            const std::uint32_t count = in.depth.at(x, y);
            const auto at = scene.at(x, y);
            best.measured = best.measured || measured(in, count);
            if (count > best.count && scene.nodes[at] && scene.nodes[at]->clean)
                best = {count, x, y, true};
        }
    return best;
}

/// The nearest sample of a row, to one side, that lies behind `own`; its distance in nodes.
inline std::pair<Sample, int> across(const MeshInput& in, const std::vector<Sample>& row, int from,
                                     int direction, int reach) {
    const std::uint32_t own = row[static_cast<std::size_t>(from)].count;
    for (int step = 1; step <= reach; ++step) {
        const int x = from + direction * step;
        if (x < 0 || x >= static_cast<int>(row.size())) break;
        const Sample& other = row[static_cast<std::size_t>(x)];
        const bool behind = other.count > 0 &&
                            (own == 0 || (other.count > own && cutBetween(in, own, other.count)));
        if (behind) return {other, step};
    }
    return {{}, 1 << 20};
}

inline Layer backgroundLayer(const MeshInput& in, const Layer& scene, int stride) {
    const int columns = (in.depth.width + stride - 2) / stride + 1;
    const int rows = (in.depth.height + stride - 2) / stride + 1;
    const double pixelsPerPanel =
        in.geometry.framing.width * in.rig.depth.resized(in.depth.width, 1).intrinsics.fx;
    const calib::DisparityLaw& law = in.geometry.law;
    const int reach = static_cast<int>(
        std::fmin(std::ceil((law.nearest - law.farthest) * pixelsPerPanel / stride) + 1, 256.0));
    const auto farCount =
        static_cast<std::uint32_t>(std::fmin(in.params.farthestM / in.depth.unitM + 1e-6, 65534.0));

    Layer layer{columns, rows, {}, {}};
    for (int j = 0; j < rows; ++j) {
        const int y = std::min(j * stride, in.depth.height - 1);
        std::vector<Sample> row;
        row.reserve(static_cast<std::size_t>(columns));
        for (int i = 0; i < columns; ++i)
            row.push_back(
                farthestAround(in, scene, std::min(i * stride, in.depth.width - 1), y, stride));
        for (int i = 0; i < columns; ++i) {
            const int x = std::min(i * stride, in.depth.width - 1);
            const Sample own = row[static_cast<std::size_t>(i)];
            const auto [left, leftSteps] = across(in, row, i, -1, reach);
            const auto [right, rightSteps] = across(in, row, i, +1, reach);
            const bool rightFarther = right.count > left.count;
            const bool takeRight = own.count == 0 ? rightFarther
                                                  : rightSteps < leftSteps ||
                                                        (rightSteps == leftSteps && rightFarther);
            Sample chosen = takeRight ? right : left;
            if (chosen.count == 0) chosen = own;
            if (chosen.count == 0) chosen = {farCount, x, y};
            if (!own.measured) chosen = {chosen.count, x, y};
            layer.nodes.push_back(node(in, x, y, chosen.count, chosen.x, chosen.y));
        }
    }
    addTriangles(layer, [](const std::array<int, 3>&) { return true; });
    return layer;
}

} // namespace autostereo::oracle
