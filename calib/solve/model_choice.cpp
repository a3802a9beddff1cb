#include "calib/solve/model_choice.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace autostereo::calibrate {

namespace {

constexpr std::size_t kMostSingles = 8, kParts = 6;

std::size_t partsOf(std::size_t views) { return views <= kMostSingles ? views : kParts; }

/// Mean square error of each view, px^2, under a camera that was not fitted to it.
std::vector<double> heldOutSquares(const Bundle& fitted) {
    const std::size_t views = fitted.firstFromBoard.size(), parts = partsOf(views);
    std::vector<double> squares(views, std::numeric_limits<double>::infinity());
    for (std::size_t part = 0; part < parts; ++part) {
        const auto isOut = [&](const Sighting& sighting) { return sighting.view % parts == part; };
        // The views left out keep their poses as unknowns of a second, smaller problem.
        Bundle rest = fitted, out = fitted;
        std::erase_if(rest.sightings, isOut);
        std::erase_if(out.sightings, [&](const Sighting& s) { return !isOut(s); });
        std::vector<std::size_t> place(views);
        const auto keep = [&](Bundle& bundle, bool wanted) {
            std::vector<calib::RigidTransform> poses;
            for (std::size_t view = 0; view < views; ++view)
                if ((view % parts == part) == wanted) {
                    place[view] = poses.size();
                    poses.push_back(bundle.firstFromBoard[view]);
                }
            for (Sighting& sighting : bundle.sightings)
                sighting.view = place[sighting.view];
            bundle.firstFromBoard = std::move(poses);
        };
        keep(rest, false);
        keep(out, true);
        adjust(rest);
        out.cameras = rest.cameras;
        out.cameras[0].fixed = true;
        adjust(out);
        for (std::size_t view = part; view < views; view += parts) {
            const double rms =
                rmsPixels(out, [&](const Sighting& s) { return s.view == place[view]; });
            squares[view] = rms * rms;
        }
    }
    return squares;
}

double meanOf(const std::vector<double>& numbers) {
    double sum = 0;
    for (const double number : numbers)
        sum += number;
    return sum / static_cast<double>(numbers.size());
}

/// How many standard errors `a`'s held-out squares lie above `b`'s, view by view.
double standardErrorsAbove(const ModelTrial& a, const ModelTrial& b) {
    const std::size_t n = a.heldOutSquares.size();
    if (n < 2 || &a == &b) return 0;
    std::vector<double> differences(n);
    for (std::size_t i = 0; i < n; ++i)
        differences[i] = a.heldOutSquares[i] - b.heldOutSquares[i];
    const double mean = meanOf(differences);
    if (!std::isfinite(mean)) return mean > 0 ? mean : 0;
    double squares = 0;
    for (const double d : differences)
        squares += (d - mean) * (d - mean);
    const double error = std::sqrt(squares / static_cast<double>(n * (n - 1)));
    return error > 0 ? mean / error : 0;
}

ModelTrial trialOf(const Bundle& fitted, const BundleFit& fit) {
    ModelTrial trial;
    trial.lens = fitted.cameras[0].lens;
    trial.rmsPx = rmsPixels(fitted, [](const Sighting&) { return true; });
    trial.focalPx = fitted.cameras[0].model.intrinsics.fx;
    trial.focal95Px = kSigmas95 * std::sqrt(fit.covariance->at(0, 0));
    trial.condition = fit.covariance->block(0, freeParameters(trial.lens)).conditionOfCorrelation();
    trial.heldOutSquares = heldOutSquares(fitted);
    trial.heldOutPx = std::sqrt(meanOf(trial.heldOutSquares));
    return trial;
}

constexpr double kClearly = 2;      // standard errors
constexpr double kTermsApart = 1e8; // condition: beyond, half the digits of a double are lost

bool predictsBetter(const ModelTrial& a, const ModelTrial& b) {
    return standardErrorsAbove(b, a) > kClearly;
}

const ModelTrial* trialFor(std::span<const ModelTrial> trials, LensModel lens) {
    const auto found = std::ranges::find(trials, lens, &ModelTrial::lens);
    return found == trials.end() ? nullptr : &*found;
}

} // namespace

std::vector<ModelTrial> tryModels(const calib::CameraModel& start, const Board& board,
                                  std::span<const BoardView> views) {
    std::vector<ModelTrial> trials;
    Bundle bundle = bundleOf(start, LensModel::Plain, board, views);
    for (const LensModel lens : kLensModels) {
        Bundle next = bundle;
        next.cameras[0].lens = lens;
        const BundleFit fit = adjust(next);
        const calib::CameraModel& camera = next.cameras[0].model;
        if (calib::problemWith(camera) || !fit.covariance) continue;
        trials.push_back(trialOf(next, fit));
        bundle = next;
    }
    return trials;
}

LensModel chooseModel(std::span<const ModelTrial> trials) {
    const ModelTrial* chosen = &trials.front();
    const auto simple = [](const ModelTrial& trial) { return trial.lens != LensModel::Rational; };
    for (const ModelTrial& trial : trials)
        if (simple(trial) && trial.heldOutPx < chosen->heldOutPx) chosen = &trial;
    const ModelTrial* const best = chosen;
    for (const ModelTrial& trial : trials)
        if (simple(trial) && !predictsBetter(*best, trial)) chosen = &trial;
    const ModelTrial* const rational = trialFor(trials, LensModel::Rational);
    if (rational != nullptr && rational->condition < kTermsApart &&
        predictsBetter(*rational, *chosen))
        return LensModel::Rational;
    return chosen->lens;
}

std::vector<std::string> warningsOf(std::span<const ModelTrial> trials, LensModel chosen) {
    constexpr double kGoodRms = 1.5;   // times the chosen model's
    constexpr double kFocalOff = 0.02; // of the focal length
    std::vector<std::string> lines;
    std::array<char, 320> text{};
    const auto say = [&](const char* form, auto... numbers) {
        std::snprintf(text.data(), text.size(), form, numbers...);
        lines.emplace_back(text.data());
    };
    const ModelTrial& best = *trialFor(trials, chosen);
    const ModelTrial* simpler = nullptr; // the next one below
    for (const ModelTrial& trial : trials)
        if (trial.lens < chosen) simpler = &trial;
    if (simpler != nullptr && simpler->rmsPx < kGoodRms * best.rmsPx) {
        const double off = std::fabs(simpler->focalPx / best.focalPx - 1);
        if (off > kFocalOff)
            say("%s would fit to %.2f px too, with a focal length of %.1f px that is %.0f %% off: "
                "the missing term hides in it (left-out views: %.2f against %.2f px)",
                nameOf(simpler->lens).data(), simpler->rmsPx, simpler->focalPx, 100 * off,
                simpler->heldOutPx, best.heldOutPx);
    }
    const ModelTrial* const rational = trialFor(trials, LensModel::Rational);
    if (rational != nullptr && chosen != LensModel::Rational && predictsBetter(*rational, best))
        say("%s predicts left-out views better (%.2f against %.2f px, focal length %.1f px) but "
            "these views do not tell its terms apart (condition %.0e): take more of them, into "
            "the corners",
            nameOf(rational->lens).data(), rational->heldOutPx, best.heldOutPx, rational->focalPx,
            rational->condition);
    return lines;
}

} // namespace autostereo::calibrate
