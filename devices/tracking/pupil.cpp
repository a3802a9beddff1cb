#include "devices/tracking/pupil.hpp"

#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace autostereo::devices {

namespace {

/// Edges count from this share of the steepest one on: skin and sclera are not smooth.
constexpr float kLeastSlope = 0.25F;
/// Of the iris' radius: edges nearer (the pupil's, highlights') or farther (lids') are another's.
constexpr double kNearest = 0.65, kFarthest = 1.4;
constexpr double kLeastAlong = 0.85; ///< cosine between an edge's slope and the way to it
constexpr double kLeastSpread = 0.01;
constexpr int kRefinements = 4;

struct Edge {
    float x, y, slopeX, slopeY; ///< the slope has length 1
    float weight;
};

float at(const GreyView& eye, int x, int y) {
    return eye.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(eye.width) +
                      static_cast<std::size_t>(x)];
}

std::vector<Edge> edgesOf(const GreyView& eye) {
    std::vector<Edge> edges;
    float steepest = 0;
    for (int y = 1; y + 1 < eye.height; ++y)
        for (int x = 1; x + 1 < eye.width; ++x) {
            const float dx = at(eye, x + 1, y) - at(eye, x - 1, y);
            const float dy = at(eye, x, y + 1) - at(eye, x, y - 1);
            const float slope = std::hypot(dx, dy);
            steepest = std::max(steepest, slope);
            if (slope > 0)
                edges.push_back(
                    {static_cast<float>(x), static_cast<float>(y), dx / slope, dy / slope, slope});
        }
    std::erase_if(edges, [&](const Edge& edge) { return edge.weight < kLeastSlope * steepest; });
    return edges;
}

/// How well the edges point away from every pixel.
std::vector<float> votes(const GreyView& eye, const std::vector<Edge>& edges, double radius) {
    const auto nearest = static_cast<float>(kNearest * radius);
    const auto farthest = static_cast<float>(kFarthest * radius);
    const int reach = static_cast<int>(std::ceil(farthest));
    std::vector<float> sums(eye.pixels.size());
    for (const Edge& edge : edges) {
        const int edgeX = static_cast<int>(edge.x), edgeY = static_cast<int>(edge.y);
        for (int y = std::max(0, edgeY - reach); y <= std::min(eye.height - 1, edgeY + reach); ++y)
            for (int x = std::max(0, edgeX - reach); x <= std::min(eye.width - 1, edgeX + reach);
                 ++x) {
                const float dx = edge.x - static_cast<float>(x),
                            dy = edge.y - static_cast<float>(y);
                const float distance = std::hypot(dx, dy);
                if (distance < nearest || distance > farthest) continue;
                const float along = (dx * edge.slopeX + dy * edge.slopeY) / distance;
                if (along > 0)
                    sums[static_cast<std::size_t>(y) * static_cast<std::size_t>(eye.width) +
                         static_cast<std::size_t>(x)] +=
                        edge.weight * along * along * (255 - at(eye, x, y));
            }
    }
    return sums;
}

/// The point that the lines through the edges along their slopes pass nearest to (least squares),
/// of edges about the iris' radius away from `start` that point away from it.
glm::dvec2 refined(const std::vector<Edge>& edges, const glm::dvec2& start, double radius) {
    glm::dmat2 normal{0};
    glm::dvec2 moment{0};
    for (const Edge& edge : edges) {
        const glm::dvec2 place{edge.x, edge.y}, slope{edge.slopeX, edge.slopeY};
        const double distance = glm::length(place - start);
        if (distance < kNearest * radius || distance > kFarthest * radius) continue;
        if (glm::dot(place - start, slope) < kLeastAlong * distance) continue;
        const glm::dmat2 across = glm::dmat2{1} - glm::outerProduct(slope, slope);
        normal += static_cast<double>(edge.weight) * across;
        moment += static_cast<double>(edge.weight) * (across * place);
    }
    // Lines of one direction only have no point in common.
    const double size = normal[0][0] + normal[1][1];
    if (!(glm::determinant(normal) > kLeastSpread * size * size)) return start;
    return glm::inverse(normal) * moment;
}

} // namespace

std::optional<glm::dvec2> pupilCentre(const GreyView& eye, double irisRadius) {
    if (irisRadius < 1 || eye.width < 2 * irisRadius || eye.height < 2 * irisRadius)
        return std::nullopt;
    const std::vector<Edge> edges = edgesOf(eye);
    const std::vector<float> sums = votes(eye, edges, irisRadius);
    const auto best = std::ranges::max_element(sums);
    if (!(*best > 0)) return std::nullopt;
    const int place = static_cast<int>(best - sums.begin());
    const glm::dvec2 peak{place % eye.width, place / eye.width};
    glm::dvec2 centre = peak;
    for (int i = 0; i < kRefinements; ++i)
        centre = refined(edges, centre, irisRadius);
    return glm::length(centre - peak) < irisRadius / 2 ? centre : peak;
}

} // namespace autostereo::devices
