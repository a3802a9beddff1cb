#include "calib/solve/rig_solver.hpp"

#include "calib/solve/pose_start.hpp"
#include "calib/solve/refusal.hpp"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>

namespace autostereo::calibrate {

namespace {

CameraCalibration oneCamera(const char* which, const Board& board, std::span<const BoardView> views,
                            int width, int height) try {
    return calibrateCamera(board, views, width, height);
} catch (const Refusal& refusal) {
    throw Refusal(std::string(which) + ": " + refusal.what());
}

/// Of one pair: colour camera from depth camera.
std::optional<calib::RigidTransform> transformOf(const CameraCalibration& depth,
                                                 const CameraCalibration& color, const Board& board,
                                                 const BoardView& depthView,
                                                 const BoardView& colorView) {
    const auto a = startingPose(depth.camera, board, depthView);
    const auto b = startingPose(color.camera, board, colorView);
    if (!a || !b) return std::nullopt;
    return *b * a->inverse();
}

double middle(std::vector<double> numbers) {
    const auto place = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
    std::nth_element(numbers.begin(), place, numbers.end());
    return *place;
}

/// The pairs' transform nearest to all others: a wrong pair cannot pull it.
calib::RigidTransform medoid(const std::vector<calib::RigidTransform>& transforms) {
    const auto distanceSum = [&](const calib::RigidTransform& from) {
        double sum = 0;
        for (const calib::RigidTransform& to : transforms) {
            const glm::dquat turn = glm::quat_cast(to.rotation * glm::transpose(from.rotation));
            sum += 2 * std::acos(std::min(1.0, std::fabs(turn.w))) +
                   glm::distance(to.translation, from.translation);
        }
        return sum;
    };
    return *std::ranges::min_element(transforms, {}, distanceSum);
}

/// Where everything stands in the joint problem: a board position for each pair, and one for each
/// view of one camera alone.
class JointProblem {
  public:
    JointProblem(const Board& board, const RigViews& views, const CameraCalibration& depth,
                 const CameraCalibration& color)
        : board_(board), views_(views), weights_{1 / (depth.rmsPx * depth.rmsPx),
                                                 1 / (color.rmsPx * color.rmsPx)} {
        bundle.cameras = {{depth.camera, depth.lens, true}, {color.camera, color.lens, true}};
        std::vector<calib::RigidTransform> transforms;
        for (const auto& [d, c] : views.pairs)
            if (const auto transform =
                    transformOf(depth, color, board, views.depth[d], views.color[c]))
                transforms.push_back(*transform);
        if (transforms.size() < kFewestPairs) refuseTooFew(transforms.size());
        bundle.secondFromFirst = medoid(transforms);
        for (const auto& pair : views.pairs)
            addPair(pair, depth, color);
    }

    static constexpr std::size_t kFewestPairs = 3;
    [[noreturn]] static void refuseTooFew(std::size_t pairs) {
        throw Refusal(std::to_string(pairs) + " pairs of pictures in which both cameras see the "
                                              "board (needs 3 or more)");
    }

    /// Drops the worst pair while it is far worse than the others.
    void dropOutliers(std::vector<ViewScore>& scores) {
        constexpr double kFarWorse = 2.5; // times the median, as for single views
        for (;;) {
            adjust(bundle);
            std::vector<double> rms;
            for (std::size_t view = 0; view < names_.size(); ++view)
                rms.push_back(rmsOf(view));
            const auto worst = std::ranges::max_element(rms);
            if (*worst <= kFarWorse * middle(rms)) return;
            const auto place = static_cast<std::size_t>(worst - rms.begin());
            scores.push_back({names_[place], *worst, true});
            remove(place);
            if (names_.size() < kFewestPairs) refuseTooFew(names_.size());
        }
    }

    /// Views of one camera alone help its own numbers.
    void addSingles(const CameraCalibration& depth, const CameraCalibration& color) {
        addSinglesOf(0, views_.depth, depth, calib::RigidTransform{});
        addSinglesOf(1, views_.color, color, bundle.secondFromFirst.inverse());
    }

    [[nodiscard]] double rmsOf(std::size_t view) const {
        return rmsPixels(bundle, [&](const Sighting& s) { return s.view == view; });
    }
    /// Names of the pairs, in the order of the first boards.
    [[nodiscard]] const std::vector<std::string>& names() const { return names_; }

    Bundle bundle;

  private:
    void addPair(const std::pair<std::size_t, std::size_t>& pair, const CameraCalibration& depth,
                 const CameraCalibration& color) {
        const BoardView &seen = views_.depth[pair.first], &other = views_.color[pair.second];
        if (!depth.isKept(seen.name) || !color.isKept(other.name)) return;
        const auto pose = startingPose(depth.camera, board_, seen);
        if (!pose) return;
        addSightings(bundle, board_, seen, names_.size(), 0, weights_[0]);
        addSightings(bundle, board_, other, names_.size(), 1, weights_[1]);
        bundle.firstFromBoard.push_back(*pose);
        names_.push_back(seen.name + " + " + other.name);
        used_.push_back(seen.name);
        used_.push_back(other.name);
    }
    void addSinglesOf(std::size_t camera, std::span<const BoardView> views,
                      const CameraCalibration& calibration, const calib::RigidTransform& toFirst) {
        for (const BoardView& view : views) {
            if (!calibration.isKept(view.name) || std::ranges::count(used_, view.name) > 0)
                continue;
            const auto pose = startingPose(calibration.camera, board_, view);
            if (!pose) continue;
            addSightings(bundle, board_, view, bundle.firstFromBoard.size(), camera,
                         weights_.at(camera));
            bundle.firstFromBoard.push_back(toFirst * *pose);
        }
    }
    void remove(std::size_t view) {
        std::erase_if(bundle.sightings, [&](const Sighting& s) { return s.view == view; });
        for (Sighting& sighting : bundle.sightings)
            if (sighting.view > view) --sighting.view;
        bundle.firstFromBoard.erase(bundle.firstFromBoard.begin() +
                                    static_cast<std::ptrdiff_t>(view));
        names_.erase(names_.begin() + static_cast<std::ptrdiff_t>(view));
    }

    const Board& board_;
    const RigViews& views_;
    std::array<double, 2> weights_;
    std::vector<std::string> names_;
    std::vector<std::string> used_; ///< views that are part of a pair, dropped ones too
};

/// Takes the joint problem's answer and its covariance over.
void takeJoint(RigCalibration& found, const Bundle& bundle, const BundleFit& fit) {
    const auto half95 = [&](std::size_t i) {
        return kSigmas95 * std::sqrt(fit.covariance->at(i, i));
    };
    std::size_t at = 0;
    const auto takeCamera = [&](CameraCalibration& calibration, const BundleCamera& camera) {
        calibration.camera = camera.model;
        const std::size_t free = freeParameters(camera.lens);
        for (std::size_t i = 0; i < free; ++i)
            calibration.half95.at(i) = half95(at + i);
        calibration.condition = fit.covariance->block(at, free).conditionOfCorrelation();
        at += free;
        return free;
    };
    found.freedom.free = {takeCamera(found.depth, bundle.cameras[0]),
                          takeCamera(found.color, bundle.cameras[1])};
    found.freedom.covariance = fit.covariance->block(0, at + 6);
    found.colorFromDepth = bundle.secondFromFirst;
    found.turn95Rad = {half95(at), half95(at + 1), half95(at + 2)};
    found.shift95M = {half95(at + 3), half95(at + 4), half95(at + 5)};
}

} // namespace

RigCalibration calibrateRig(const Board& board, const RigViews& views, const PictureSizes& sizes) {
    RigCalibration found;
    found.depth =
        oneCamera("depth camera", board, views.depth, sizes.depthWidth, sizes.depthHeight);
    found.color =
        oneCamera("colour camera", board, views.color, sizes.colorWidth, sizes.colorHeight);
    JointProblem problem(board, views, found.depth, found.color);
    if (problem.names().size() < JointProblem::kFewestPairs)
        JointProblem::refuseTooFew(problem.names().size());
    problem.dropOutliers(found.pairs);
    const auto isPair = [&](const Sighting& s) { return s.view < problem.names().size(); };
    found.separateRmsPx = rmsPixels(problem.bundle, isPair);
    problem.addSingles(found.depth, found.color);
    for (BundleCamera& camera : problem.bundle.cameras)
        camera.fixed = false;
    const BundleFit fit = adjust(problem.bundle);
    if (!fit.covariance) throw Refusal("the pairs leave the cameras' numbers open (add views)");
    found.jointRmsPx = rmsPixels(problem.bundle, isPair);
    for (std::size_t view = 0; view < problem.names().size(); ++view)
        found.pairs.push_back({problem.names()[view], problem.rmsOf(view), false});
    takeJoint(found, problem.bundle, fit);
    found.registration = registrationErrors(found.rig(""), found.freedom, kReportedRangesM);
    return found;
}

} // namespace autostereo::calibrate
