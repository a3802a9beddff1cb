#pragma once

#include "tests/oracle/mesh_oracle.hpp"

#include <algorithm>
#include <limits>

// Slow, obvious, double-precision twin of the view passes: mesh layers -> one view's tile.

namespace autostereo::oracle {

/// RGB as doubles 0..255, top row first.
struct Picture {
    int width = 0;
    int height = 0;
    std::vector<std::array<double, 3>> pixels;

    [[nodiscard]] const std::array<double, 3>& at(int x, int y) const {
        return pixels[static_cast<std::size_t>(std::clamp(y, 0, height - 1)) *
                          static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(std::clamp(x, 0, width - 1))];
    }
    /// Bilinear, at a position in pixels (centres at integers), clamped to the edge.
    [[nodiscard]] std::array<double, 3> sample(double x, double y) const {
        const double left = std::floor(x), top = std::floor(y);
        const int i = static_cast<int>(left), j = static_cast<int>(top);
        std::array<double, 3> mixed{};
        for (std::size_t c = 0; c < 3; ++c) {
            const double upper = at(i, j)[c] + (at(i + 1, j)[c] - at(i, j)[c]) * (x - left);
            const double lower =
                at(i, j + 1)[c] + (at(i + 1, j + 1)[c] - at(i, j + 1)[c]) * (x - left);
            mixed[c] = upper + (lower - upper) * (y - top);
        }
        return mixed;
    }
};

/// One view: position b, tile of width x height, drawn with a depth test. Colours are rounded to
/// whole levels as an 8-bit atlas stores them.
class ViewDrawing {
  public:
    ViewDrawing(int width, int height, const std::array<double, 3>& clear)
        : picture_{width, height, {}},
          depth_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                 std::numeric_limits<double>::infinity()) {
        picture_.pixels.assign(depth_.size(), clear);
    }

    /// Layers drawn later are behind all earlier ones, whatever their depth.
    void draw(const Layer& layer, double b, const Picture& color) {
        const std::vector<double> before = depth_;
        for (const auto& corners : layer.triangles)
            drawTriangle(layer, corners, b, color, before);
    }
    [[nodiscard]] const Picture& picture() const { return picture_; }

  private:
    struct Corner {
        double x, y; ///< tile pixels, y down, pixel centres at +0.5
        const Node* node;
    };

    void drawTriangle(const Layer& layer, const std::array<int, 3>& corners, double b,
                      const Picture& color, const std::vector<double>& before) {
        std::array<Corner, 3> c{};
        for (std::size_t i = 0; i < 3; ++i) {
            const Node& n = *layer.nodes[static_cast<std::size_t>(corners[i])];
            c[i] = {(n.u - b * n.d) * picture_.width, (1 - n.v) * picture_.height, &n};
        }
        const double area =
            (c[1].x - c[0].x) * (c[2].y - c[0].y) - (c[2].x - c[0].x) * (c[1].y - c[0].y);
        if (area == 0) return;
        const auto [left, right] = std::minmax({c[0].x, c[1].x, c[2].x});
        const auto [top, bottom] = std::minmax({c[0].y, c[1].y, c[2].y});
        const int lastX = std::min(picture_.width - 1, static_cast<int>(std::floor(right)));
        const int lastY = std::min(picture_.height - 1, static_cast<int>(std::floor(bottom)));
        for (int y = std::max(0, static_cast<int>(std::floor(top))); y <= lastY; ++y)
            for (int x = std::max(0, static_cast<int>(std::floor(left))); x <= lastX; ++x)
                shade(c, area, x, y, color, before);
    }

    void shade(const std::array<Corner, 3>& c, double area, int x, int y, const Picture& color,
               const std::vector<double>& before) {
        const double px = x + 0.5, py = y + 0.5;
        std::array<double, 3> weight{};
        double inverseDepth = 0, s = 0, t = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const Corner &p = c[(i + 1) % 3], &q = c[(i + 2) % 3];
            weight[i] = ((p.x - px) * (q.y - py) - (q.x - px) * (p.y - py)) / area;
            if (weight[i] < 0) return;
            inverseDepth += weight[i] / c[i].node->z;
            s += weight[i] * c[i].node->s / c[i].node->z; // perspective-correct
            t += weight[i] * c[i].node->t / c[i].node->z;
        }
        const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(picture_.width) +
                        static_cast<std::size_t>(x);
        if (std::isfinite(before[at]) || 1 / inverseDepth >= depth_[at]) return;
        depth_[at] = 1 / inverseDepth;
        auto level = color.sample(s / inverseDepth * color.width - 0.5,
                                  t / inverseDepth * color.height - 0.5);
        for (double& channel : level)
            channel = std::round(channel);
        picture_.pixels[at] = level;
    }

    Picture picture_;
    std::vector<double> depth_;
};

} // namespace autostereo::oracle
