#include "calib/solve/time_offset.hpp"

#include "calib/solve/least_squares.hpp"
#include "calib/solve/refusal.hpp"

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace autostereo::calibrate {

namespace {

constexpr std::size_t kFewest = 20; // half while parts are left out
constexpr double kFarthestS = 0.1;  // of offsets that are tried: pairs wait no longer
constexpr double kWidestGapS = 0.2; // between colour places that are joined
constexpr double kWorst95S = 5e-3;

/// The colour camera's places as a curve: a cubic through a moment's two neighbours, whose slopes
/// are those of the parabolas through three places (exact for parabolas, whatever the spacing).
class Curve {
  public:
    explicit Curve(std::span<const TimedPlace> places) : places_(places) {}

    struct At {
        glm::dvec3 place, velocity;
    };
    [[nodiscard]] std::optional<At> at(double timeS) const {
        const auto after = std::ranges::upper_bound(places_, timeS, {}, &TimedPlace::timeS);
        const std::ptrdiff_t i = after - places_.begin();
        if (i < 2 || i + 1 >= std::ssize(places_)) return std::nullopt;
        const TimedPlace &a = here(i - 1), &b = here(i);
        const double gap = b.timeS - a.timeS;
        if (!(here(i + 1).timeS - here(i - 2).timeS < 3 * kWidestGapS) || !(gap > 0))
            return std::nullopt;
        const glm::dvec3 from = gap * slope(i - 1), to = gap * slope(i);
        const double u = (timeS - a.timeS) / gap;
        const glm::dvec3 c2 = 3.0 * (b.place - a.place) - 2.0 * from - to;
        const glm::dvec3 c3 = 2.0 * (a.place - b.place) + from + to;
        return At{a.place + u * (from + u * (c2 + u * c3)),
                  (from + u * (2.0 * c2 + 3.0 * u * c3)) / gap};
    }

  private:
    [[nodiscard]] const TimedPlace& here(std::ptrdiff_t i) const {
        return places_[static_cast<std::size_t>(i)];
    }
    [[nodiscard]] glm::dvec3 slope(std::ptrdiff_t i) const {
        const TimedPlace &before = here(i - 1), &now = here(i), &after = here(i + 1);
        const double d0 = now.timeS - before.timeS, d1 = after.timeS - now.timeS;
        if (!(d0 > 0) || !(d1 > 0)) return glm::dvec3(0);
        return ((now.place - before.place) * (d1 / d0) + (after.place - now.place) * (d0 / d1)) /
               (d0 + d1);
    }
    std::span<const TimedPlace> places_;
};

/// Late by x[0] seconds, shifted by x[1], x[2], x[3] metres.
using State = std::array<double, 4>;

glm::dvec3 shiftOf(const State& state) { return {state[1], state[2], state[3]}; }

/// The places that are compared at an offset, and where the curve is then.
template<class Take>
std::size_t compare(std::span<const TimedPlace> depth, const Curve& curve, double lateS,
                    const Take& take) {
    std::size_t moments = 0;
    for (const TimedPlace& seen : depth)
        if (const auto at = curve.at(seen.timeS + lateS)) {
            take(seen.place, *at);
            ++moments;
        }
    return moments;
}

/// Mean square about the mean difference at an offset; infinite where too little can be compared.
double spread(std::span<const TimedPlace> depth, const Curve& curve, double lateS) {
    glm::dvec3 sum(0);
    double squares = 0;
    const std::size_t moments =
        compare(depth, curve, lateS, [&](const glm::dvec3& seen, const Curve::At& at) {
            sum += seen - at.place;
            squares += glm::dot(seen - at.place, seen - at.place);
        });
    if (moments < kFewest) return std::numeric_limits<double>::infinity();
    const auto count = static_cast<double>(moments);
    return (squares - glm::dot(sum, sum) / count) / count;
}

double coarseOffset(std::span<const TimedPlace> depth, const Curve& curve) {
    constexpr double kStepS = 5e-3;
    double best = std::numeric_limits<double>::infinity(), found = 0;
    for (int i = 0; i <= std::lround(2 * kFarthestS / kStepS); ++i) {
        const double lateS = i * kStepS - kFarthestS;
        const double off = spread(depth, curve, lateS);
        if (off < best) {
            best = off;
            found = lateS;
        }
    }
    if (!std::isfinite(best))
        throw Refusal("both cameras saw the board move in too few pictures (needs " +
                      std::to_string(kFewest) + " one after the other)");
    return found;
}

LeastSquaresFit settle(std::span<const TimedPlace> depth, const Curve& curve,
                       const glm::dvec3& weights, State& state) {
    return minimise(
        state, state.size(),
        [&](const State& now, NormalEquations& equations) {
            return compare(depth, curve, now[0], [&](const glm::dvec3& seen, const Curve::At& at) {
                       const glm::dvec3 off = seen - at.place - shiftOf(now);
                       for (glm::length_t k = 0; k < 3; ++k)
                           equations.add(std::array{Slope{0, at.velocity[k]},
                                                    Slope{static_cast<std::size_t>(k) + 1, 1.0}},
                                         off[k], weights[k]);
                   }) >= kFewest / 2;
        },
        [](State now, const std::vector<double>& step) {
            for (std::size_t i = 0; i < now.size(); ++i)
                now.at(i) += step[i];
            return now;
        });
}

/// Half the 95 % interval by leaving out a tenth of the time after the other (block jackknife,
/// Student's t with 9 degrees of freedom): one colour place bends the curve for several depth
/// places, whose residuals are therefore not independent.
double late95(std::span<const TimedPlace> depth, const Curve& curve, const glm::dvec3& weights,
              const State& found) {
    constexpr std::size_t kTenths = 10;
    constexpr double kStudent95 = 2.262;
    double sum = 0, squares = 0;
    for (std::size_t block = 0; block < kTenths; ++block) {
        std::vector<TimedPlace> others;
        for (std::size_t i = 0; i < depth.size(); ++i)
            if (i * kTenths / depth.size() != block) others.push_back(depth[i]);
        State state = found;
        if (!settle(others, curve, weights, state).inverse)
            return std::numeric_limits<double>::infinity(); // it hung on that tenth alone
        sum += state[0] - found[0];
        squares += (state[0] - found[0]) * (state[0] - found[0]);
    }
    const double variance = (squares - sum * sum / kTenths) * (kTenths - 1) / kTenths;
    return kStudent95 * std::sqrt(variance);
}

/// Between two pictures the board goes farther than noise places it: else the curve's velocity is
/// noise, which answers to any offset.
bool isMotion(std::span<const TimedPlace> depth, const glm::dvec3& rmsM) {
    constexpr double kLeast = 4; // noise alone makes about 1
    glm::dvec3 squares(0);
    for (std::size_t i = 1; i < depth.size(); ++i) {
        const glm::dvec3 step = depth[i].place - depth[i - 1].place;
        squares += step * step;
    }
    const glm::dvec3 steps = glm::sqrt(squares / static_cast<double>(depth.size())) / rmsM;
    return std::max({steps.x, steps.y, steps.z}) >= kLeast;
}

} // namespace

TimeOffset timeOffset(std::span<const TimedPlace> depth, std::span<const TimedPlace> color) {
    constexpr int kRounds = 3; // axes' weights and the answer in turn
    constexpr double kLeastRmsM = 1e-5;
    const Curve curve(color);
    State state{coarseOffset(depth, curve), 0, 0, 0};
    glm::dvec3 weights(1e6);
    TimeOffset found;
    for (int round = 0; round < kRounds; ++round) {
        const LeastSquaresFit fit = settle(depth, curve, weights, state);
        if (!fit.inverse) throw Refusal("the board did not move");
        glm::dvec3 squares(0);
        found.moments =
            compare(depth, curve, state[0], [&](const glm::dvec3& seen, const Curve::At& at) {
                const glm::dvec3 off = seen - at.place - shiftOf(state);
                squares += off * off;
            });
        found.rmsM = glm::sqrt(squares / static_cast<double>(found.moments));
        for (glm::length_t k = 0; k < 3; ++k)
            weights[k] = 1 / std::pow(std::fmax(found.rmsM[k], kLeastRmsM), 2);
    }
    found.late95S = late95(depth, curve, weights, state);
    found.colorLateS = state[0];
    found.shift = shiftOf(state);
    if (!(found.late95S <= kWorst95S) || !isMotion(depth, found.rmsM))
        throw Refusal("the board moved too little to tell the clocks apart within 5 ms; wave it "
                      "faster, to the sides");
    return found;
}

} // namespace autostereo::calibrate
