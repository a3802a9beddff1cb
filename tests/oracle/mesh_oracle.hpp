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

// Slow, obvious, double-precision twin of DepthMesh: depth counts -> mesh.

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

inline std::optional<Node> node(const MeshInput& in, int x, int y, std::uint32_t count) {
    const calib::CameraModel camera = in.rig.depth.resized(in.depth.width, in.depth.height);
    const double z = count * in.depth.unitM;
    const auto ray = camera.unproject({x, y});
    if (!ray) return std::nullopt;
    const glm::dvec3 point = in.rig.colorFromDepth * glm::dvec3{ray->x * z, ray->y * z, z};
    const auto pixel = in.rig.color.project(point);
    if (!pixel) return std::nullopt;
    const calib::Framing& f = in.geometry.framing;
    const double sx = point.x / point.z, sy = point.y / point.z;
    const double across = f.uprightFromCamera[0][0] * sx + f.uprightFromCamera[1][0] * sy;
    const double down = f.uprightFromCamera[0][1] * sx + f.uprightFromCamera[1][1] * sy;
    return Node{(across - f.left) / f.width,
                (f.bottom - down) / f.height,
                disparity(in.geometry.law, point.z),
                point.z,
                (pixel->x + 0.5) / in.rig.color.intrinsics.width,
                (pixel->y + 0.5) / in.rig.color.intrinsics.height};
}

inline void addTriangles(const MeshInput& in, Layer& layer) {
    const auto add = [&](std::array<int, 3> corners) {
        std::uint32_t nearest = 65535, farthest = 0;
        for (const int corner : corners) {
            if (!layer.nodes[static_cast<std::size_t>(corner)]) return;
            const std::uint32_t count = in.depth.counts[static_cast<std::size_t>(corner)];
            nearest = std::min(nearest, count);
            farthest = std::max(farthest, count);
        }
        if (!cutBetween(in, nearest, farthest)) layer.triangles.push_back(corners);
    };
    for (int y = 0; y + 1 < layer.height; ++y)
        for (int x = 0; x + 1 < layer.width; ++x) {
            const int here = y * layer.width + x, below = here + layer.width;
            add({here, below, here + 1});
            add({here + 1, below, below + 1});
        }
}

inline Layer meshLayer(const MeshInput& in) {
    Layer layer{in.depth.width, in.depth.height, {}, {}};
    for (int y = 0; y < layer.height; ++y)
        for (int x = 0; x < layer.width; ++x) {
            const std::uint32_t count = in.depth.at(x, y);
            layer.nodes.push_back(measured(in, count) ? node(in, x, y, count) : std::nullopt);
        }
    addTriangles(in, layer);
    return layer;
}

} // namespace autostereo::oracle
