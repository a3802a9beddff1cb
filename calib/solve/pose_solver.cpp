#include "calib/solve/pose_solver.hpp"

#include "calib/solve/bundle.hpp"
#include "calib/solve/refusal.hpp"

#include <glm/geometric.hpp>

#include <cmath>

namespace autostereo::calibrate {

namespace {

/// The pairs as sightings of one rigid "board" by one known camera.
BundleFit refine(const calib::CameraModel& camera, std::span<const PointPixel> pairs,
                 std::span<const std::size_t> places, calib::RigidTransform& pose, double& rmsPx) {
    Bundle bundle;
    bundle.cameras.push_back({camera, LensModel::Rational, true});
    bundle.firstFromBoard.push_back(pose);
    for (const std::size_t place : places)
        bundle.sightings.push_back(
            {0, 0, pairs[place].point, pairs[place].pixel, pairs[place].weight});
    BundleFit fit = adjust(bundle);
    pose = bundle.firstFromBoard.front();
    rmsPx = rmsPixels(bundle, [](const Sighting&) { return true; });
    return fit;
}

std::vector<std::size_t> agreeing(const calib::CameraModel& camera,
                                  std::span<const PointPixel> pairs,
                                  const calib::RigidTransform& pose, double tolerancePx) {
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const auto pixel = camera.project(pose * pairs[i].point);
        if (pixel && pairs[i].weight > 0 && glm::distance(*pixel, pairs[i].pixel) < tolerancePx)
            places.push_back(i);
    }
    return places;
}

constexpr std::size_t kFewest = 6;

[[noreturn]] void refuse(const std::string& what) {
    throw Refusal(what + " (needs 6 or more that agree, not in one line, over the picture)");
}

/// Refines over what agrees until that stays.
PoseFit settled(const calib::CameraModel& camera, std::span<const PointPixel> pairs,
                double tolerancePx, PoseFit found) {
    constexpr int kMostRounds = 10;
    for (int round = 0; round < kMostRounds; ++round) {
        const BundleFit fit =
            refine(camera, pairs, found.inliers, found.cameraFromPoints, found.rmsPx);
        if (!fit.covariance) refuse("the points lie in one place or in line");
        found.covariance = *fit.covariance;
        auto next = agreeing(camera, pairs, found.cameraFromPoints, tolerancePx);
        if (next.size() < kFewest) refuse(std::to_string(next.size()) + " pairs of points agree");
        if (next == found.inliers) break;
        found.inliers = std::move(next);
    }
    return found;
}

} // namespace

PoseFit solvePose(const calib::CameraModel& camera, std::span<const PointPixel> pairs,
                  double tolerancePx) {
    if (pairs.size() < kFewest) refuse(std::to_string(pairs.size()) + " pairs of points");
    const auto start = ransacPose(camera, pairs, tolerancePx);
    if (!start) refuse("no six of " + std::to_string(pairs.size()) + " pairs of points agree");
    return settled(camera, pairs, tolerancePx, {start->cameraFromPoints, start->inliers, 0, {}});
}

PoseFit settlePose(const calib::CameraModel& camera, std::span<const PointPixel> pairs,
                   double tolerancePx, const calib::RigidTransform& start) {
    auto inliers = agreeing(camera, pairs, start, tolerancePx);
    if (inliers.size() < kFewest) refuse(std::to_string(inliers.size()) + " pairs of points agree");
    return settled(camera, pairs, tolerancePx, {start, std::move(inliers), 0, {}});
}

} // namespace autostereo::calibrate
