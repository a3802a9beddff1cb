#include "calib/solve/camera_solver.hpp"

#include "calib/solve/model_choice.hpp"
#include "calib/solve/pose_start.hpp"
#include "calib/solve/refusal.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <set>

namespace autostereo::calibrate {

namespace {

std::string formatted(const char* form, double number) {
    std::array<char, 256> text{};
    std::snprintf(text.data(), text.size(), form, number);
    return text.data();
}

void refuseTooFew(std::size_t views, const std::string& which) {
    if (views >= kFewestViews) return;
    throw Refusal(std::to_string(views) + " views of the board " + which + " (needs " +
                  std::to_string(kFewestViews) +
                  " or more, tilted to all sides, near and far, in every part of the picture)");
}

double median(std::vector<double> numbers) {
    const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
    std::nth_element(numbers.begin(), middle, numbers.end());
    return *middle;
}

double viewRms(const Bundle& bundle, std::size_t view) {
    return rmsPixels(bundle, [&](const Sighting& sighting) { return sighting.view == view; });
}

/// Drops the worst view while it is far worse than the others: a corner taken for another, a board
/// that moved. Their scores go to `views`.
std::vector<BoardView> withoutOutliers(const calib::CameraModel& start, const Board& board,
                                       std::span<const BoardView> given,
                                       std::vector<ViewScore>& scores) {
    constexpr double kFarWorse = 2.5; // times the median; good views stay below 2
    std::vector<BoardView> kept(given.begin(), given.end());
    for (;;) {
        Bundle bundle = bundleOf(start, LensModel::Tangential, board, kept);
        adjust(bundle);
        std::vector<double> rms;
        for (std::size_t view = 0; view < kept.size(); ++view)
            rms.push_back(viewRms(bundle, view));
        const auto worst = std::ranges::max_element(rms);
        if (*worst <= kFarWorse * median(rms)) return kept;
        const auto place = worst - rms.begin();
        scores.push_back({kept[static_cast<std::size_t>(place)].name, *worst, true});
        kept.erase(kept.begin() + place);
        refuseTooFew(kept.size(), "agree with each other");
    }
}

/// Largest angle between two boards' normals.
double largestTilt(const Bundle& bundle) {
    double least = 1;
    for (const calib::RigidTransform& a : bundle.firstFromBoard)
        for (const calib::RigidTransform& b : bundle.firstFromBoard)
            least = std::min(least, glm::dot(a.rotation[2], b.rotation[2]));
    return std::acos(std::clamp(least, -1.0, 1.0));
}

double coverageOf(std::span<const BoardView> views, int width, int height) {
    constexpr int kColumns = 8, kRows = 6;
    std::set<std::pair<int, int>> cells;
    for (const BoardView& view : views)
        for (const glm::dvec2& pixel : view.pixels)
            cells.emplace(static_cast<int>(kColumns * (pixel.x + 0.5) / width),
                          static_cast<int>(kRows * (pixel.y + 0.5) / height));
    return static_cast<double>(cells.size()) / (kColumns * kRows);
}

/// Longest distance of a corner from the first one of its view, over the picture's diagonal.
double largestBoard(std::span<const BoardView> views, int width, int height) {
    double longest = 0;
    for (const BoardView& view : views)
        for (const glm::dvec2& pixel : view.pixels)
            longest = std::max(longest, glm::distance(pixel, view.pixels.front()));
    return longest / std::hypot(width, height);
}

void refuseFar(std::span<const BoardView> views, int width, int height) {
    constexpr double kSmallestBoard = 0.12; // of the diagonal
    const double largest = largestBoard(views, width, height);
    if (largest < kSmallestBoard)
        throw Refusal(formatted("the board is too far away: it spans %.0f %% of the picture's "
                                "diagonal at most (needs 12; come nearer or print it larger)",
                                100 * largest));
}

void refuseDegenerate(const CameraCalibration& found) {
    constexpr double kLeastTilt = 0.17;      // 10 degrees
    constexpr double kFocalKnownTo = 0.05;   // half the 95 % interval
    constexpr double kDegrees = 57.29577951; // per radian
    if (found.tiltRad < kLeastTilt)
        throw Refusal(
            formatted("the boards are nearly parallel, within %.1f degrees: focal length and "
                      "distance cannot be told apart (tilt the board by 20 degrees or more to "
                      "several sides)",
                      kDegrees * found.tiltRad));
    const double focal = found.half95[0] / found.camera.intrinsics.fx;
    if (!(focal < kFocalKnownTo))
        throw Refusal(formatted("the focal length is known to %.1f %% only (95 %%; needs 5): add "
                                "views that are tilted more, nearer, and in the corners",
                                100 * focal));
}

/// Intervals and condition; infinite where the views leave something open.
void takeCovariance(CameraCalibration& found, const BundleFit& fit) {
    const std::size_t free = freeParameters(found.lens);
    for (std::size_t i = 0; i < free; ++i)
        found.half95.at(i) = fit.covariance ? kSigmas95 * std::sqrt(fit.covariance->at(i, i))
                                            : std::numeric_limits<double>::infinity();
    found.condition = fit.covariance ? fit.covariance->block(0, free).conditionOfCorrelation()
                                     : std::numeric_limits<double>::infinity();
}

void addWarnings(CameraCalibration& found) {
    constexpr double kGoodCoverage = 0.5, kBadCondition = 1e6;
    found.warnings = warningsOf(found.trials, found.lens);
    if (found.coverage < kGoodCoverage)
        found.warnings.push_back(
            formatted("corners lie in %.0f %% of the picture: beyond them the distortion is a "
                      "guess (needs 50)",
                      100 * found.coverage));
    if (found.condition > kBadCondition)
        found.warnings.push_back(formatted(
            "the numbers trade off against each other (condition %.0e)", found.condition));
}

} // namespace

bool CameraCalibration::isKept(const std::string& name) const {
    return std::ranges::any_of(
        views, [&](const ViewScore& view) { return view.name == name && !view.rejected; });
}

void addSightings(Bundle& bundle, const Board& board, const BoardView& view, std::size_t index,
                  std::size_t camera, double weight) {
    for (std::size_t i = 0; i < view.size(); ++i)
        bundle.sightings.push_back(
            {index, camera, board.corner(view.ids[i]), view.pixels[i], weight});
}

Bundle bundleOf(const calib::CameraModel& camera, LensModel lens, const Board& board,
                std::span<const BoardView> views) {
    Bundle bundle;
    bundle.cameras.push_back({camera, lens, false});
    for (std::size_t view = 0; view < views.size(); ++view) {
        const auto pose = startingPose(camera, board, views[view]);
        if (!pose) throw Refusal(views[view].name + ": its corners lie in line");
        bundle.firstFromBoard.push_back(*pose);
        addSightings(bundle, board, views[view], view, 0);
    }
    return bundle;
}

CameraCalibration calibrateCamera(const Board& board, std::span<const BoardView> views, int width,
                                  int height) {
    refuseTooFew(views.size(), "were found");
    refuseFar(views, width, height);
    const auto start = startingCamera(board, views, width, height);
    if (!start)
        throw Refusal("the boards tell no focal length: all are parallel to the picture (tilt the "
                      "board by 20 degrees or more to several sides)");
    CameraCalibration found;
    const std::vector<BoardView> kept = withoutOutliers(*start, board, views, found.views);
    found.trials = tryModels(*start, board, kept);
    if (found.trials.empty()) throw Refusal("no lens model fits the views");
    found.lens = chooseModel(found.trials);

    Bundle bundle = bundleOf(*start, LensModel::Plain, board, kept);
    BundleFit fit;
    for (const LensModel lens : kLensModels) {
        if (lens > found.lens) break;
        bundle.cameras[0].lens = lens;
        fit = adjust(bundle);
    }
    found.camera = bundle.cameras[0].model;
    found.rmsPx = rmsPixels(bundle, [](const Sighting&) { return true; });
    for (const ModelTrial& trial : found.trials)
        if (trial.lens == found.lens) found.heldOutPx = trial.heldOutPx;
    for (std::size_t view = 0; view < kept.size(); ++view)
        found.views.push_back({kept[view].name, viewRms(bundle, view), false});
    takeCovariance(found, fit);
    found.tiltRad = largestTilt(bundle);
    found.coverage = coverageOf(kept, width, height);
    refuseDegenerate(found);
    addWarnings(found);
    return found;
}

} // namespace autostereo::calibrate
