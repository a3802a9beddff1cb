#pragma once

#include "tests/oracle/scene_oracle.hpp"

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/mat4x4.hpp>

#include <cstddef>
#include <cstdlib>
#include <optional>
#include <vector>

/// The super-multi-view paper's hybrid in double precision: what is seen from anywhere in the fan
/// by way of a few reference viewpoints' pictures. Of each row every piece of surface is tried, no
/// walk.
namespace autostereo::oracle {

/// All that a pixel is lit from.
struct HybridSurface {
    double cover = 0; ///< 0: nothing
    double disparity = 0;
    glm::dvec3 normal{0}, diffuse{0}, specular{0}, emissive{0};
    double shininess = 0;
};

/// Reference viewpoints' pictures, rows from the bottom, disparities in panel widths at |b| = 1.
struct References {
    int width, margin, height, count; ///< width: with a margin on either side
    double first, step;               ///< b
    double edge;                      ///< a larger step in disparity is one
    std::vector<HybridSurface> texels;

    [[nodiscard]] int tileWidth() const { return width - 2 * margin; }
    [[nodiscard]] double positionOf(int reference) const { return first + reference * step; }
    [[nodiscard]] const HybridSurface& at(int reference, int x, int y) const {
        const int column = std::clamp(x, 0, width - 1);
        return texels[static_cast<std::size_t>((reference * height + y) * width + column)];
    }
    [[nodiscard]] bool isEdge(int reference, int left, int y) const {
        return std::abs(at(reference, left, y).disparity - at(reference, left + 1, y).disparity) >
               edge;
    }
};

/// Where a ray ends in a reference: at a texel coordinate, or in the wall between two columns.
struct ReferenceHit {
    double disparity;
    double x; ///< centres at 0.5
    bool isWall;
    int wallLeft; ///< the wall's left column
};

/// The ray x_r = x + (b - b_r) d tileWidth against every piece of row y: slopes between texels of
/// one surface, level halves beside edges, walls between those. The nearest one hit.
inline std::optional<ReferenceHit> hitIn(const References& in, int reference, int y, double x,
                                         double b) {
    const double reach = (b - in.positionOf(reference)) * in.tileWidth();
    const double start = x + in.margin;
    std::optional<ReferenceHit> nearest;
    const auto meet = [&](double x0, double d0, double x1, double d1) { // a piece, x0 <= x1
        const double g0 = x0 - start - reach * d0, g1 = x1 - start - reach * d1;
        if (g0 * g1 > 0) return;
        const double share = g0 == g1 ? 0 : g0 / (g0 - g1);
        const double d = d0 + share * (d1 - d0);
        if (nearest && nearest->disparity >= d) return;
        const bool isWall = x0 == x1;
        nearest =
            ReferenceHit{d, x0 + share * (x1 - x0), isWall, static_cast<int>(std::floor(x0)) - 1};
    };
    for (int i = 0; i + 1 < in.width; ++i) {
        const double d0 = in.at(reference, i, y).disparity;
        const double d1 = in.at(reference, i + 1, y).disparity;
        if (!in.isEdge(reference, i, y)) {
            meet(i + 0.5, d0, i + 1.5, d1);
            continue;
        }
        meet(i + 0.5, d0, i + 1, d0);
        meet(i + 1, d1, i + 1.5, d1);
        meet(i + 1, d0, i + 1, d1);
    }
    return nearest;
}

/// A pixel of a view: in the nearest reference that sees it, else a hole in the nearest one.
struct HybridRoot {
    int reference;
    ReferenceHit hit;
};
inline std::vector<int> referencesByDistance(const References& in, double b) {
    std::vector<int> order(static_cast<std::size_t>(in.count));
    for (int i = 0; i < in.count; ++i)
        order[static_cast<std::size_t>(i)] = i;
    std::ranges::stable_sort(order, {},
                             [&](int reference) { return std::abs(b - in.positionOf(reference)); });
    return order;
}
inline HybridRoot rootOf(const References& in, int y, double x, double b) {
    const std::vector<int> order = referencesByDistance(in, b);
    for (const int reference : order)
        if (const auto hit = hitIn(in, reference, y, x, b); hit && !hit->isWall)
            return {reference, *hit};
    return {order.front(), hitIn(in, order.front(), y, x, b).value()};
}

inline HybridSurface mixed(const HybridSurface& a, const HybridSurface& b, double share) {
    HybridSurface mix = a;
    mix.disparity = (1 - share) * a.disparity + share * b.disparity;
    mix.normal = (1 - share) * a.normal + share * b.normal;
    mix.diffuse = (1 - share) * a.diffuse + share * b.diffuse;
    return mix;
}

/// What a reference shows at a texel coordinate; specular, shininess, emission of the nearer texel.
inline HybridSurface surfaceAt(const References& in, int reference, int y, double x) {
    const int left = static_cast<int>(std::floor(x - 0.5));
    const double share = x - 0.5 - left;
    const HybridSurface &a = in.at(reference, left, y), &b = in.at(reference, left + 1, y);
    if (in.isEdge(reference, left, y)) return share < 0.5 ? a : b;
    HybridSurface surface = share < 0.5 ? a : b;
    const HybridSurface between = mixed(a, b, share);
    surface.disparity = between.disparity;
    surface.normal = between.normal;
    surface.diffuse = between.diffuse;
    return surface;
}

/// Eq. 5: (d_r V_l + d_l V_r) / (d_l + d_r) of everything that is lit, what is nothing as cover 0.
inline HybridSurface filled(const HybridSurface& left, const HybridSurface& right, double toLeft,
                            double toRight) {
    const double l = left.cover * toRight, r = right.cover * toLeft;
    HybridSurface fill;
    fill.cover = (l + r) / (toLeft + toRight);
    if (l + r == 0) return fill;
    const auto between = [&](const auto& a, const auto& b) { return (l * a + r * b) / (l + r); };
    fill.disparity = between(left.disparity, right.disparity);
    fill.normal = between(left.normal, right.normal);
    fill.diffuse = between(left.diffuse, right.diffuse);
    fill.specular = between(left.specular, right.specular);
    fill.emissive = between(left.emissive, right.emissive);
    fill.shininess = between(left.shininess, right.shininess);
    return fill;
}

/// A ray lost at an edge, between the edge's own ends as this eye sees them.
inline HybridSurface acrossWall(const References& in, const HybridRoot& root, int y, double x,
                                double b) {
    const double reach = (b - in.positionOf(root.reference)) * in.tileWidth();
    const int left = root.hit.wallLeft;
    const HybridSurface &l = in.at(root.reference, left, y),
                        &r = in.at(root.reference, left + 1, y);
    const double wall = left + 1.0, at = x + in.margin;
    return filled(l, r, std::abs(at - (wall - reach * l.disparity)),
                  std::abs(at - (wall - reach * r.disparity)));
}

/// The sheared camera array (Eq. 1): display space -> clip space of an eye (e_x, 0, D), the panel's
/// edges at +-1. `halfWidth`, `halfHeight` of the panel, metres.
inline glm::dmat4 shearedCamera(double eyeX, double distance, double halfWidth, double halfHeight) {
    const double near = 0.1 * distance, far = 10 * distance;
    const glm::dmat4 view = glm::translate(glm::dmat4(1), glm::dvec3(-eyeX, 0, -distance));
    const double k = near / distance;
    const glm::dmat4 centre =
        glm::frustum(-halfWidth * k, halfWidth * k, -halfHeight * k, halfHeight * k, near, far);
    glm::dmat4 shear(1); // x moves with depth, so that the panel's plane stays
    shear[2][0] = -eyeX / distance;
    return centre * shear * view;
}

/// Display space, of what is lit from the eye at b: Eq. 3 by the law of disparities.
struct PanelForm {
    double widthM, heightM, distanceM, fanHalfWidth, flattening;
};
inline glm::dvec3 placeSeen(const PanelForm& form, double u, double v, double b, double d) {
    const double height = d * form.distanceM / (form.fanHalfWidth + d);
    const double nearer = 1 - height / form.distanceM;
    return {(u + b * d - 0.5) * form.widthM * nearer, (v - 0.5) * form.heightM * nearer,
            height / form.flattening};
}

/// 0 to 255; `u`, `v` of the panel, v upwards; before a black background.
inline glm::dvec3 colorOf(const HybridSurface& surface, const gpu::SceneParams& look,
                          const PanelForm& form, double u, double v, double b) {
    if (surface.cover == 0) return glm::dvec3(0);
    glm::dvec3 light = surface.diffuse;
    if (look.shading == gpu::SceneShading::PerPixel) {
        const glm::dvec3 eye(b * form.fanHalfWidth * form.widthM, 0, form.distanceM);
        const SceneLightSum sum = lightAt(look, placeSeen(form, u, v, b, surface.disparity),
                                          glm::normalize(surface.normal), eye, surface.shininess);
        light = light * sum.diffuse + surface.specular * sum.specular;
    }
    light += surface.emissive;
    return surface.cover * glm::dvec3(levelOf(light.r), levelOf(light.g), levelOf(light.b));
}

} // namespace autostereo::oracle
