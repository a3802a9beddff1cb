#include "devices/kinect2/wraps.hpp"

#include "devices/kinect2/vectorised.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace autostereo::devices::kinect2 {

namespace {

/// Chi squared on top for paths outside of the range asked for. Not infinite: light that speaks
/// for such a path must not look like a sure measurement of the next best inside.
constexpr float kOutside = 12;

/// Nearest whole number of |x| < 16; the cast rounds towards zero and is one instruction.
inline float nearest(float x) { return static_cast<float>(static_cast<int>(x + 16.5F)) - 16; }

struct Hypothesis {
    float path;
    float misfit; ///< sum of weighted squares, units^2, later chi squared
};

/// The two likeliest wraps of the 16 MHz phase for a path that the others leave open by 6 units.
struct HypothesisPair {
    Hypothesis first, second;
};

struct Weights {
    float w0, w1, w2; ///< sum 1
};

/// `lift` 0 or 1: which of the two wraps of the 80 MHz phase that 120 MHz tells apart.
inline HypothesisPair pairFor(float t0, float t1, float t2, float lift, const Weights& w) {
    const float pathOf0 = t0 + 3 * lift;
    const float apart = pathOf0 - t2 - 2 * nearest((pathOf0 - t2) * 0.5F);
    const float w02 = w.w0 + w.w2;
    const float path = pathOf0 - apart * (w.w2 / w02);
    const float misfit = apart * apart * (w.w0 * w.w2 / w02);
    // Multiples of 6 make multiples of 3 modulo 15: the step that brings it nearest to t1.
    const float thirds = (t1 - path) * (1.0F / 3);
    const float step = nearest(thirds);
    const float rest = 3 * (thirds - step);
    const auto with = [&](float steps, float left) {
        const float count = 3 * (steps + 5); // 6 to 36
        const auto fives = static_cast<float>(static_cast<int>(count * 0.2F + 0.01F));
        return Hypothesis{path + 6 * (count - 5 * fives) + left * w.w1,
                          misfit + left * left * (w.w1 * w02)};
    };
    const float further = rest < 0 ? -1.0F : 1.0F;
    return {with(step, rest), with(step + further, rest - 3 * further)};
}

inline Hypothesis better(const Hypothesis& a, const Hypothesis& b) {
    const bool first = a.misfit <= b.misfit;
    return {first ? a.path : b.path, first ? a.misfit : b.misfit};
}
inline Hypothesis worse(const Hypothesis& a, const Hypothesis& b) {
    const bool second = a.misfit <= b.misfit;
    return {second ? b.path : a.path, second ? b.misfit : a.misfit};
}

struct Limits {
    float least, most;
};

inline Hypothesis limited(const Hypothesis& h, float scale, const Limits& limits) {
    const bool inside = h.path >= limits.least && h.path <= limits.most;
    return {h.path, h.misfit * scale + (inside ? 0 : kOutside)};
}

} // namespace

void WrapRow::clear() {
    for (auto& line : path)
        line.fill(-1000);
    for (auto& line : misfit)
        line.fill(0);
}

WrapFinder::WrapFinder(const std::array<double, kFrequencies>& amplitudeFactors,
                       const PhaseNoise& noise, double leastPath, double mostPath)
    : least_(static_cast<float>(leastPath)), most_(static_cast<float>(mostPath)) {
    // The same sample noise is the more phase the more an amplitude had to be multiplied, and
    // the more path the longer the period.
    std::array<double, kFrequencies> weights{};
    double sum = 0;
    for (std::size_t i = 0; i < kFrequencies; ++i) {
        weights[i] = 1 / std::pow(kPeriods[i] * amplitudeFactors[i], 2);
        sum += weights[i];
    }
    weight0_ = static_cast<float>(weights[0] / sum);
    weight1_ = static_cast<float>(weights[1] / sum);
    weight2_ = static_cast<float>(weights[2] / sum);
    sampleVariance_ = static_cast<float>(noise.sampleSigma * noise.sampleSigma * 2 / 3);
    systematicVariance_ = static_cast<float>(noise.systematic * noise.systematic);
    misfitScale_ = static_cast<float>(sum * std::pow(2 * std::numbers::pi, 2));
}

AUTOSTEREO_VECTORISED
void WrapFinder::find(const PhaseRow& phases, WrapRow& result) const {
    const Weights weights{weight0_, weight1_, weight2_};
    const Limits limits{least_, most_};
    const float sampleVariance = sampleVariance_, systematic = systematicVariance_;
    const float misfitScale = misfitScale_;
    for (std::size_t x = 0; x < kWidth; ++x) {
        const float t0 = phases.turns[0][x] * 3;
        const float t1 = phases.turns[1][x] * 15;
        const float t2 = phases.turns[2][x] * 2;
        const float amplitude =
            (phases.amplitudes[0][x] + phases.amplitudes[1][x] + phases.amplitudes[2][x]) *
            (1.0F / 3);
        const float light = amplitude * amplitude;
        const float scale = misfitScale * light / (sampleVariance + systematic * light);
        const auto even = pairFor(t0, t1, t2, 0, weights);
        const auto odd = pairFor(t0, t1, t2, 1, weights);
        const auto e1 = limited(even.first, scale, limits);
        const auto e2 = limited(even.second, scale, limits);
        const auto o1 = limited(odd.first, scale, limits);
        const auto o2 = limited(odd.second, scale, limits);
        const auto lowEven = better(e1, e2), lowOdd = better(o1, o2);
        const auto first = better(lowEven, lowOdd);
        const auto second = better(worse(lowEven, lowOdd), better(worse(e1, e2), worse(o1, o2)));
        result.path[0][x + 1] = first.path;
        result.misfit[0][x + 1] = first.misfit;
        result.path[1][x + 1] = second.path;
        result.misfit[1][x + 1] = second.misfit;
    }
}

namespace {

using CostLine = std::array<float, kWidth>;

/// What the neighbour `shift - 1` columns aside thinks of each hypothesis: nothing against the one
/// that continues its own likelier one, for another what that costs it, at most kMostSay.
AUTOSTEREO_VECTORISED
void addSay(const WrapRow& neighbours, std::size_t shift, const WrapRow::Line& paths,
            CostLine& costs) {
    constexpr float kMostSay = 9;
    // Units at which a surface continues no longer: 560 mm, for that is how far dark pixels
    // scatter; wraps lie 1.2 m and more apart. Half of it doubles the wrong wraps at low light.
    constexpr float kApart = 0.9F;
    constexpr float kSlope = kMostSay / (kApart * kApart);
    const float* const likely = neighbours.path[0].data() + shift;
    const float* const unlikely = neighbours.path[1].data() + shift;
    const float* const likelyMisfit = neighbours.misfit[0].data() + shift;
    const float* const unlikelyMisfit = neighbours.misfit[1].data() + shift;
    for (std::size_t x = 0; x < kWidth; ++x) {
        const float d0 = paths[x + 1] - likely[x], d1 = paths[x + 1] - unlikely[x];
        const float against0 = d0 * d0 * kSlope;
        const float against1 = d1 * d1 * kSlope + (unlikelyMisfit[x] - likelyMisfit[x]);
        costs[x] += std::min(std::min(against0, against1), kMostSay);
    }
}

AUTOSTEREO_VECTORISED
void choose(const WrapRow& own, const CostLine& costs0, const CostLine& costs1, ChosenRow& result) {
    for (std::size_t x = 0; x < kWidth; ++x) {
        const float path0 = own.path[0][x + 1], path1 = own.path[1][x + 1];
        result.path[x] = costs0[x] <= costs1[x] ? path0 : path1;
        result.margin[x] = std::abs(costs1[x] - costs0[x]);
    }
}

} // namespace

void chooseWraps(const WrapRow& above, const WrapRow& own, const WrapRow& below,
                 ChosenRow& result) {
    alignas(64) std::array<CostLine, 2> costs;
    for (std::size_t i = 0; i < 2; ++i) {
        std::copy_n(own.misfit[i].begin() + 1, kWidth, costs[i].begin());
        for (std::size_t shift = 0; shift <= 2; ++shift) {
            addSay(above, shift, own.path[i], costs[i]);
            addSay(below, shift, own.path[i], costs[i]);
        }
        addSay(own, 0, own.path[i], costs[i]);
        addSay(own, 2, own.path[i], costs[i]);
    }
    choose(own, costs[0], costs[1], result);
}

} // namespace autostereo::devices::kinect2
