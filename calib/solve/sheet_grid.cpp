#include "calib/solve/sheet_grid.hpp"

#include "calib/solve/least_squares.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace autostereo::calibrate {

namespace {

constexpr int kBlocks = PlaneWave::kBlocks;
constexpr int kNodes = kBlocks + 1; ///< each way: about one at each corner of a block

std::size_t nodeAt(int column, int row) {
    return static_cast<std::size_t>(row) * kNodes + static_cast<std::size_t>(column);
}

/// One block as one camera saw it: the mean of the nodes around it by their weights.
struct Reading {
    std::size_t sight;
    std::map<std::size_t, double> weights;
    double correction; ///< cycles
};

/// Adds a place's bilinear weights; in shares of the way from the first node to the last.
void addPlace(std::map<std::size_t, double>& weights, const glm::dvec2& place, double weight) {
    const glm::dvec2 at = glm::dvec2(std::clamp(place.x, 0.0, 1.0), std::clamp(place.y, 0.0, 1.0)) *
                          static_cast<double>(kNodes - 1);
    const int left = std::min(static_cast<int>(at.x), kNodes - 2);
    const int upper = std::min(static_cast<int>(at.y), kNodes - 2);
    const double x = at.x - left, y = at.y - upper;
    weights[nodeAt(left, upper)] += weight * (1 - x) * (1 - y);
    weights[nodeAt(left + 1, upper)] += weight * x * (1 - y);
    weights[nodeAt(left, upper + 1)] += weight * (1 - x) * y;
    weights[nodeAt(left + 1, upper + 1)] += weight * x * y;
}

/// An eye aside sees a block of the panel through lenses that are not right above it.
std::map<std::size_t, double> weightsOf(const calib::LensArray& lenses, const glm::dvec2& panelM,
                                        const glm::dvec3& eye, int column, int row) {
    constexpr std::array kQuarters{0.25, 0.75};
    std::map<std::size_t, double> weights;
    for (const double across : kQuarters)
        for (const double down : kQuarters) {
            const glm::dvec2 point = panelM * glm::dvec2((column + across) / kBlocks - 0.5,
                                                         0.5 - (row + down) / kBlocks);
            const glm::dvec2 crossing = point + (glm::dvec2(eye) - point) * (lenses.gapM / eye.z);
            addPlace(
                weights,
                {0.5 + crossing.x / lenses.correctedM.x, 0.5 - crossing.y / lenses.correctedM.y},
                0.25);
        }
    return weights;
}

std::vector<Reading> readingsOf(const calib::LensArray& lenses, const glm::dvec2& panelM,
                                std::span<const PanelSight> sights) {
    std::vector<Reading> readings;
    for (std::size_t sight = 0; sight < sights.size(); ++sight) {
        auto left = sights[sight].fringes.residual.begin();
        for (int row = 0; row < kBlocks; ++row)
            for (int column = 0; column < kBlocks; ++column, ++left)
                if (*left) // fringes are what is assumed less what is there
                    readings.push_back({sight,
                                        weightsOf(lenses, panelM, sights[sight].eye, column, row),
                                        -**left});
    }
    return readings;
}

/// How much a grid resists bending, next to one reading. With the least, a wave as long as the
/// panel loses 1/1000 of its height; with the most a third.
constexpr std::array kStiffnesses{0.1, 0.3, 1.0, 3.0, 10.0, 30.0};

/// Without this, a chequered grid has the mean 0 in all blocks.
void addStiffness(NormalEquations& equations, double stiffness) {
    for (int line = 0; line < kNodes; ++line)
        for (int at = 1; at < kNodes - 1; ++at) {
            equations.add(
                std::array<Slope, 3>{
                    {{nodeAt(at - 1, line), 1}, {nodeAt(at, line), -2}, {nodeAt(at + 1, line), 1}}},
                0, stiffness);
            equations.add(
                std::array<Slope, 3>{
                    {{nodeAt(line, at - 1), 1}, {nodeAt(line, at), -2}, {nodeAt(line, at + 1), 1}}},
                0, stiffness);
        }
}

/// From all readings but those of one sight.
std::optional<std::vector<double>> nodesFrom(const std::vector<Reading>& readings, double stiffness,
                                             std::optional<std::size_t> without) {
    NormalEquations equations(nodeAt(0, kNodes));
    for (const Reading& reading : readings) {
        if (reading.sight == without) continue;
        std::vector<Slope> slopes;
        for (const auto& [node, weight] : reading.weights)
            slopes.push_back({node, weight});
        equations.add(slopes, reading.correction, 1);
    }
    addStiffness(equations, stiffness);
    equations.complete();
    return equations.matrix.solved(equations.right, 0);
}

double predicted(const std::vector<double>& nodes, const Reading& reading) {
    double cycles = 0;
    for (const auto& [node, weight] : reading.weights)
        cycles += weight * nodes[node];
    return cycles;
}

/// What grids from the other sights leave in each.
std::vector<double> leftOut(const std::vector<Reading>& readings, std::size_t sights,
                            double stiffness) {
    std::vector<double> left;
    for (std::size_t sight = 0; sight < sights; ++sight) {
        const auto nodes = nodesFrom(readings, stiffness, sight);
        if (!nodes) return {};
        for (const Reading& reading : readings)
            if (reading.sight == sight)
                left.push_back(reading.correction - predicted(*nodes, reading));
    }
    return left;
}

double percentile95(std::vector<double> values) {
    if (values.empty()) return 0;
    for (double& value : values)
        value = std::abs(value);
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(values.size() * 95 / 100);
    std::ranges::nth_element(values, place);
    return *place;
}

double rms(const std::vector<double>& values) {
    double squares = 0;
    for (const double value : values)
        squares += value * value;
    return values.empty() ? 0 : std::sqrt(squares / static_cast<double>(values.size()));
}

struct Stiffness {
    double value = kStiffnesses.back();
    std::vector<double> left; ///< out; empty: nothing could be told
};

/// The one whose grids foretell best what other sights see: what no two of them share is noise,
/// and how they sample sub-pixels, which are wide (a barrier's five make steps of a fifth).
Stiffness bestStiffness(const std::vector<Reading>& readings, std::size_t sights) {
    Stiffness best;
    for (const double stiffness : kStiffnesses) {
        auto left = leftOut(readings, sights, stiffness);
        if (!left.empty() && (best.left.empty() || rms(left) < rms(best.left)))
            best = {stiffness, std::move(left)};
    }
    return best;
}

} // namespace

SheetGrid fitSheetGrid(const calib::LensArray& lenses, const glm::dvec2& panelM,
                       std::span<const PanelSight> sights, double least) {
    constexpr double kMost = 1.0 / 3;  // cycles: further, and neighbours may be whole lenses apart
    constexpr double kLeastGain = 0.2; // of the variance
    const auto readings = readingsOf(lenses, panelM, sights);
    std::vector<double> seen;
    seen.reserve(readings.size());
    for (const Reading& reading : readings)
        seen.push_back(reading.correction);
    const Stiffness best = bestStiffness(readings, sights.size());
    const auto nodes = nodesFrom(readings, best.value, std::nullopt);
    std::vector<double> common;
    for (const Reading& reading : readings)
        if (nodes) common.push_back(predicted(*nodes, reading));
    SheetGrid found;
    found.deformed = percentile95(common);
    found.left = percentile95(seen);
    found.leftRms = rms(seen);
    const double before = found.leftRms, after = rms(best.left);
    const bool helps = !best.left.empty() && after * after < (1 - kLeastGain) * before * before;
    const bool wraps = std::ranges::any_of(seen, [](double off) { return std::abs(off) > kMost; });
    if (!nodes || !helps || wraps || found.deformed < least) return found;
    found.correction = {kNodes, kNodes, *nodes};
    found.left = percentile95(best.left);
    found.leftRms = after;
    return found;
}

} // namespace autostereo::calibrate
