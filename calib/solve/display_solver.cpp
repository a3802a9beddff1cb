#include "calib/solve/display_solver.hpp"

#include "calib/solve/display_numbers.hpp"
#include "calib/solve/least_squares.hpp"
#include "calib/solve/refusal.hpp"
#include "calib/solve/rig_solver.hpp"
#include "calib/solve/sheet_grid.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace autostereo::calibrate {

namespace {

constexpr std::size_t kNumbers = 4;
/// Steps of each number in units of its span.
using Steps = std::array<double, kNumbers>;
/// Slope along x and y and middle of a sight's fringes, cycles.
using Wave = std::array<double, 3>;

constexpr const char* kTooClose =
    "these places do not tell pitch, slant and fan: stand further to the sides";

/// Where fringes are exact no better than this: lenses sample sub-pixels that are boxes, and the
/// board places them on the panel. Cycles; the scatter of simulated panels.
constexpr double kFloor = 3e-4;

/// Seen less modelled; whole cycles in the middle are nothing.
Wave difference(const PanelSight& sight, const Wave& modelled) {
    const PlaneWave& seen = sight.fringes;
    const double middle = seen.middle - modelled[2];
    return {seen.slopeX - modelled[0], seen.slopeY - modelled[1], middle - std::round(middle)};
}

/// Where a maker's formula places a pixel's colours on the average, from the pixel's centre, which
/// is what a camera sees.
glm::dvec2 meanOffset(const calib::SubpixelLayout& panel) {
    glm::dvec2 sum(0);
    for (const auto& cell : panel.offsetsM)
        for (const glm::dvec2& offset : cell)
            sum += offset;
    return sum / (3.0 * static_cast<double>(panel.offsetsM.size()));
}

/// The display under test as a function of its four numbers.
class Model {
  public:
    explicit Model(const calib::DisplayProfile& assumed)
        : assumed_(assumed), fringes_(*calib::Fringes::of(assumed)),
          panelM_(assumed.widthM, assumed.heightM()),
          colors_(meanOffset(calib::subpixelLayout(assumed).value())) {}

    [[nodiscard]] calib::DisplayProfile display(const Steps& steps) const {
        calib::DisplayProfile moved = assumed_;
        const auto numbers = measuredNumbers(moved);
        for (std::size_t i = 0; i < kNumbers; ++i)
            *numbers[i].value += steps.at(i) * numbers[i].span;
        return moved;
    }
    [[nodiscard]] calib::LensArray lenses(const Steps& steps) const {
        calib::LensArray found = calib::displayOptics(display(steps))->lenses;
        found.correction = {};
        return found;
    }
    /// The fringes that are seen from `eye`: whatever is seen lies on an axis.
    [[nodiscard]] Wave seen(const Steps& steps, const glm::dvec3& eye) const {
        const calib::LensArray real = lenses(steps);
        const auto cycles = [&](double x, double y) {
            const glm::dvec2 point = panelM_ * glm::dvec2(x, y) + colors_;
            return fringes_.cycles(point) - real.coordinate(eye, point);
        };
        const double middle = cycles(0, 0);
        return {cycles(0.5, 0) - cycles(-0.5, 0), cycles(0, 0.5) - cycles(0, -0.5), middle};
    }
    /// The display's own phase at its corners and middle, cycles.
    [[nodiscard]] std::array<double, 5> phases(const Steps& steps) const {
        constexpr std::array<std::array<double, 2>, 5> kPlaces{
            {{0, 0}, {-0.5, -0.5}, {0.5, -0.5}, {-0.5, 0.5}, {0.5, 0.5}}};
        const calib::LensArray real = lenses(steps);
        std::array<double, 5> cycles{};
        for (std::size_t i = 0; i < kPlaces.size(); ++i)
            cycles.at(i) =
                real.coordinate({0, 0, assumed_.viewingDistanceM},
                                panelM_ * glm::dvec2(kPlaces.at(i)[0], kPlaces.at(i)[1]));
        return cycles;
    }

  private:
    calib::DisplayProfile assumed_;
    calib::Fringes fringes_;
    glm::dvec2 panelM_;
    glm::dvec2 colors_;
};

/// Central differences of a function of the four numbers.
template<class Function>
auto slopesOf(const Function& function, const Steps& at) {
    constexpr double kStep = 1e-3; // of a span: far above rounding, far below any bend
    std::array<decltype(function(at)), kNumbers> slopes;
    for (std::size_t i = 0; i < kNumbers; ++i) {
        Steps up = at, down = at;
        up.at(i) += kStep;
        down.at(i) -= kStep;
        slopes.at(i) = function(up);
        const auto below = function(down);
        for (std::size_t k = 0; k < below.size(); ++k)
            slopes.at(i).at(k) = (slopes.at(i).at(k) - below.at(k)) / (2 * kStep);
    }
    return slopes;
}

/// Variances of a sight's three numbers: of the fringes themselves, and of where the camera stood.
Wave variancesOf(const Model& model, const PanelSight& sight, const Steps& steps) {
    const double step = 1e-4 * sight.eye.z;
    std::array<Wave, 3> slopes;
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        glm::dvec3 up = sight.eye, down = sight.eye;
        up[axis] += step;
        down[axis] -= step;
        const Wave above = model.seen(steps, up), below = model.seen(steps, down);
        for (std::size_t k = 0; k < above.size(); ++k)
            slopes.at(static_cast<std::size_t>(axis)).at(k) =
                (above.at(k) - below.at(k)) / (2 * step);
    }
    Wave variances{};
    for (std::size_t k = 0; k < variances.size(); ++k) {
        const glm::dvec3 slope(slopes[0].at(k), slopes[1].at(k), slopes[2].at(k));
        variances.at(k) = sight.fringes.covariance.at(k, k) + kFloor * kFloor +
                          glm::dot(slope, sight.eyeCovariance * slope);
    }
    return variances;
}

bool linearise(const Model& model, std::span<const PanelSight> sights, const Steps& steps,
               NormalEquations& equations) {
    const calib::LensArray lenses = model.lenses(steps);
    if (!(lenses.pitchM > 0) || !(lenses.gapM > 0)) return false;
    for (const PanelSight& sight : sights) {
        if (!(sight.eye.z > lenses.gapM)) return false;
        const auto seen = [&](const Steps& at) { return model.seen(at, sight.eye); };
        const Wave off = difference(sight, seen(steps));
        const auto slopes = slopesOf(seen, steps);
        const Wave variances = variancesOf(model, sight, steps);
        for (std::size_t k = 0; k < off.size(); ++k) {
            std::array<Slope, kNumbers> row{};
            for (std::size_t i = 0; i < kNumbers; ++i)
                row.at(i) = {i, slopes.at(i).at(k)};
            equations.add(row, off.at(k), 1 / variances.at(k));
        }
    }
    return true;
}

struct Fit {
    Steps steps{};
    LeastSquaresFit quality;
};

/// The fan is tried over a range, for the sights' middles are known up to whole cycles only.
Fit fit(const Model& model, std::span<const PanelSight> sights) {
    constexpr std::array kFans{0.0, -8.0, -4.0, 4.0, 8.0, 14.0, 20.0}; // 5 % each: 0.6 to 2 times
    Fit best;
    best.quality.cost = std::numeric_limits<double>::infinity();
    for (const double fan : kFans) {
        // Off any round number, at which rational sheets are shifted by half a step.
        Fit attempt{{1.4e-4, 1.7e-4, 0, fan}, {}};
        attempt.quality = minimise(
            attempt.steps, kNumbers,
            [&](const Steps& steps, NormalEquations& equations) {
                return linearise(model, sights, steps, equations);
            },
            [](Steps steps, const std::vector<double>& step) {
                for (std::size_t i = 0; i < kNumbers; ++i)
                    steps.at(i) += step[i];
                return steps;
            });
        if (attempt.quality.converged && attempt.quality.inverse &&
            attempt.quality.cost < 0.9 * best.quality.cost)
            best = std::move(attempt);
    }
    return best;
}

std::string percent(double share) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%+.1f %%", 100 * share);
    return text.data();
}

void refuseOtherModel(const calib::LensArray& was, const calib::LensArray& is,
                      const std::string& name) {
    constexpr double kPitch = 0.02, kSlant = 0.0175, kGap = 0.25;
    const double pitch = is.pitchM / was.pitchM - 1;
    const double slant = std::atan(is.slant) - std::atan(was.slant);
    const double gap = (is.gapM / is.pitchM) / (was.gapM / was.pitchM) - 1;
    if (std::abs(pitch) < kPitch && std::abs(slant) < kSlant && std::abs(gap) < kGap) return;
    throw Refusal("the panel photographed is no " + name + ": pitch " + percent(pitch) +
                  ", slant " + std::to_string(slant * 57.2957795) + " degrees, lens distance " +
                  percent(gap) + " off (allowed 2 %, 1 degree, 25 %); name its own model");
}

/// Root of the mean square over the sights' three numbers each, cycles.
double disagreement(const Model& model, std::span<const PanelSight> sights, const Steps& steps) {
    double squares = 0;
    for (const PanelSight& sight : sights)
        for (const double off : difference(sight, model.seen(steps, sight.eye)))
            squares += off * off;
    return std::sqrt(squares / (3 * static_cast<double>(sights.size())));
}

double halfOf(const SymmetricMatrix& covariance, const std::array<double, kNumbers>& slopes) {
    double variance = 0;
    for (std::size_t i = 0; i < kNumbers; ++i)
        for (std::size_t j = 0; j < kNumbers; ++j)
            variance += slopes.at(i) * slopes.at(j) * covariance.at(i, j);
    return kSigmas95 * std::sqrt(variance);
}

/// What the numbers leave, in place of a grid that the assumed display had.
void addSheetGrid(DisplayCalibration& found, const calib::LensArray& lenses,
                  std::span<const PanelSight> sights) {
    constexpr double kLeastViews = 0.05;
    calib::DisplayProfile& display = found.display;
    const SheetGrid sheet = fitSheetGrid(lenses, {display.widthM, display.heightM()}, sights,
                                         kLeastViews / display.views);
    *calib::phaseGrid(display.law) = calib::turnedGrid(display, sheet.correction);
    found.deformationViews = display.views * sheet.deformed;
    found.localViews = display.views * sheet.left;
    if (sheet.correction.cycles.empty()) return;
    // What the sights do not agree in, each node has from all of them.
    const double scatter = sheet.leftRms / std::sqrt(static_cast<double>(sights.size()));
    found.half95Views = std::hypot(found.half95Views, display.views * kSigmas95 * scatter);
}

} // namespace

DisplayCalibration calibrateDisplay(const calib::DisplayProfile& assumed,
                                    std::span<const PanelSight> sights) {
    constexpr double kMostDisagreement = 0.02; // cycles
    DisplayCalibration found;
    found.display = assumed;
    const auto numbers = measuredNumbers(found.display);
    if (numbers.size() != kNumbers || !calib::displayOptics(assumed))
        throw Refusal("a display of type " + assumed.type + " cannot be measured from photographs");
    if (sights.size() < 2)
        throw Refusal("one place tells no fan: photograph from two places or more, side by side");
    const Model model(assumed);
    const Fit best = fit(model, sights);
    if (!best.quality.inverse) throw Refusal(kTooClose);
    const double off = disagreement(model, sights, best.steps);
    if (off > kMostDisagreement)
        throw Refusal("the places disagree by " + std::to_string(off) +
                      " lens periods (allowed 0.02): something moved, or the display named is "
                      "another model");
    refuseOtherModel(model.lenses({}), model.lenses(best.steps), assumed.model);

    found.display = model.display(best.steps);
    SymmetricMatrix covariance = *best.quality.inverse;
    covariance.scale(std::max(1.0, best.quality.cost / std::max(1.0, best.quality.freedom())));
    const auto measured = measuredNumbers(found.display);
    for (std::size_t i = 0; i < kNumbers; ++i) {
        const DisplayNumber& number = measured[i];
        found.numbers.push_back(
            {number.table, number.key, *number.value / number.unit,
             kSigmas95 * std::sqrt(covariance.at(i, i)) * number.span / number.unit});
    }
    constexpr double kLeastKnown = 0.1; // of the fan
    if (!(found.numbers.back().half95 < kLeastKnown * std::abs(found.numbers.back().value)))
        throw Refusal(kTooClose);
    const auto slopes = slopesOf([&](const Steps& at) { return model.phases(at); }, best.steps);
    for (std::size_t k = 0; k < slopes[0].size(); ++k) {
        std::array<double, kNumbers> slope{};
        for (std::size_t i = 0; i < kNumbers; ++i)
            slope.at(i) = slopes.at(i).at(k);
        found.half95Views = std::max(found.half95Views, assumed.views * halfOf(covariance, slope));
    }
    found.rmsViews = assumed.views * off;
    addSheetGrid(found, model.lenses(best.steps), sights);
    return found;
}

} // namespace autostereo::calibrate
