#pragma once

#include "tests/oracle/mesh_oracle.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

// Slow, obvious, double-precision twin of DepthRegistration: each triangle of the depth grid, and
// what stands in place of cut ones, cast pixel by pixel into the colour camera's picture.

namespace autostereo::oracle {

/// Two pictures of 1/z: measured (the nearest wins), and behind it extruded (the farthest wins).
class RegistrationDrawing {
  public:
    RegistrationDrawing(const MeshInput& in, int extrudePx, int width, int height)
        : in_(in), camera_(in.rig.depth.resized(in.depth.width, in.depth.height)),
          extrudePx_(extrudePx), width_(width), height_(height),
          measured_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)),
          extruded_(measured_) {
        for (int y = -1; y < in.depth.height; ++y)
            for (int x = -1; x < in.depth.width; ++x) {
                drawTriangle({{{x, y}, {x, y + 1}, {x + 1, y}}});
                drawTriangle({{{x + 1, y + 1}, {x, y + 1}, {x + 1, y}}});
            }
    }
    /// Metres; 0: none.
    [[nodiscard]] double at(std::size_t pixel) const {
        const double inverse = measured_[pixel] > 0 ? measured_[pixel] : extruded_[pixel];
        return inverse > 0 ? 1 / inverse : 0;
    }

  private:
    struct Pixel {
        int x, y;
    };
    struct Place {
        double x, y, inverseZ; ///< pixels of the result, centres at one half
    };
    struct HalfWay {
        Pixel a, b;
    };
    using Corners = std::array<Pixel, 3>; ///< the right angle first

    [[nodiscard]] std::uint32_t countAt(const Pixel& p) const {
        if (p.x < 0 || p.y < 0 || p.x >= in_.depth.width || p.y >= in_.depth.height) return 0;
        const std::uint32_t count = in_.depth.at(p.x, p.y);
        const auto ray = camera_.unproject({p.x, p.y});
        return measured(in_, count) && ray && placeOf(*ray, count) ? count : 0;
    }
    [[nodiscard]] std::optional<Place> placeOf(const glm::dvec2& ray, std::uint32_t count) const {
        const double z = count * in_.depth.unitM;
        const glm::dvec3 point = in_.rig.colorFromDepth * glm::dvec3{ray * z, z};
        const auto pixel = in_.rig.color.project(point);
        if (!pixel) return std::nullopt;
        const calib::Intrinsics& color = in_.rig.color.intrinsics;
        return Place{(pixel->x + 0.5) / color.width * width_,
                     (pixel->y + 0.5) / color.height * height_, 1 / point.z};
    }
    /// Where the lens has no ray for a pixel, straight on from the mirrored one.
    [[nodiscard]] glm::dvec2 rayOf(const Pixel& p, const Pixel& owner) const {
        const auto own = camera_.unproject({owner.x, owner.y});
        const auto mirrored = camera_.unproject({2 * owner.x - p.x, 2 * owner.y - p.y});
        return camera_.unproject({p.x, p.y}).value_or(mirrored ? 2.0 * *own - *mirrored : *own);
    }

    void drawTriangle(const Corners& corners) {
        std::array<std::uint32_t, 3> counts{};
        for (std::size_t i = 0; i < 3; ++i)
            counts[i] = countAt(corners[i]);
        const std::uint32_t nearest = std::min({counts[0], counts[1], counts[2]});
        const std::uint32_t farthest = std::max({counts[0], counts[1], counts[2]});
        if (nearest > 0 && !cutBetween(in_, nearest, farthest)) {
            std::array<Place, 3> places{};
            for (std::size_t i = 0; i < 3; ++i)
                places[i] = *placeOf(rayOf(corners[i], corners[i]), counts[i]);
            fill(places, true);
            return;
        }
        for (std::size_t i = 0; i < 3; ++i)
            if (counts[i] > 0) drawPart(corners, i, counts[i]);
        const std::uint32_t other = std::min(counts[1], counts[2]);
        if (extrudePx_ > 0 && other < counts[0] && cutBetween(in_, other, counts[0]))
            goOn(corners, counts[0]);
    }

    void drawPart(const Corners& corners, std::size_t i, std::uint32_t count) {
        const Pixel &own = corners[i], &a = corners[(i + 1) % 3], &b = corners[(i + 2) % 3];
        if (i == 0) {
            flat(own, {{{own, own}, {own, a}, {a, b}}}, count, true);
            flat(own, {{{own, own}, {a, b}, {own, b}}}, count, true);
        } else {
            flat(own, {{{own, own}, {own, a}, {own, b}}}, count, true);
        }
        if (extrudePx_ > 0) flat(own, {{{own, own}, {a, a}, {b, b}}}, count, false);
    }

    void goOn(const Corners& corners, std::uint32_t count) {
        const Pixel& own = corners[0];
        const int dx = corners[1].x + corners[2].x - 2 * own.x; // -1 or 1
        const int dy = corners[1].y + corners[2].y - 2 * own.y;
        const auto away = [&](int x, int y) {
            const int last = extrudePx_, next = extrudePx_ + 1;
            return HalfWay{{own.x + last * x, own.y + last * y},
                           {own.x + next * x, own.y + next * y}};
        };
        flat(own, {{{own, own}, away(dx, 0), away(0, dy)}}, count, false);
        flat(own, {{away(dx, dy), away(dx, 0), away(0, dy)}}, count, false);
    }

    /// Part of the picture at the owner's depth along the depth camera's axis.
    void flat(const Pixel& owner, const std::array<HalfWay, 3>& spots, std::uint32_t count,
              bool isMeasured) {
        std::array<Place, 3> places{};
        for (std::size_t i = 0; i < 3; ++i) {
            const auto place =
                placeOf(0.5 * (rayOf(spots[i].a, owner) + rayOf(spots[i].b, owner)), count);
            places[i] = place.value_or(*placeOf(rayOf(owner, owner), count));
        }
        fill(places, isMeasured);
    }

    void fill(const std::array<Place, 3>& p, bool isMeasured) {
        const double area =
            (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y);
        if (area == 0) return;
        const auto [left, right] = std::minmax({p[0].x, p[1].x, p[2].x});
        const auto [top, bottom] = std::minmax({p[0].y, p[1].y, p[2].y});
        for (int y = std::max(0, static_cast<int>(top)); y < height_ && y <= bottom; ++y)
            for (int x = std::max(0, static_cast<int>(left)); x < width_ && x <= right; ++x) {
                double inverseZ = 0;
                bool inside = true;
                for (std::size_t i = 0; i < 3; ++i) {
                    const Place &a = p[(i + 1) % 3], &b = p[(i + 2) % 3];
                    const double weight =
                        ((a.x - x - 0.5) * (b.y - y - 0.5) - (b.x - x - 0.5) * (a.y - y - 0.5)) /
                        area;
                    inside = inside && weight >= 0;
                    inverseZ += weight * p[i].inverseZ;
                }
                const int pixel = y * width_ + x;
                if (inside) keep(static_cast<std::size_t>(pixel), inverseZ, isMeasured);
            }
    }

    void keep(std::size_t pixel, double inverseZ, bool isMeasured) {
        double& best = isMeasured ? measured_[pixel] : extruded_[pixel];
        if (best == 0 || (isMeasured ? inverseZ > best : inverseZ < best)) best = inverseZ;
    }

    const MeshInput& in_;
    calib::CameraModel camera_;
    int extrudePx_, width_, height_;
    std::vector<double> measured_, extruded_; ///< 1/z; 0: nothing
};

} // namespace autostereo::oracle
