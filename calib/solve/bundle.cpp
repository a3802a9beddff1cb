#include "calib/solve/bundle.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat2x2.hpp>

#include <limits>

namespace autostereo::calibrate {

namespace {

constexpr std::size_t kPoseParameters = 6;

/// Where each unknown's free parameters begin.
struct Layout {
    explicit Layout(const Bundle& bundle) {
        for (const BundleCamera& camera : bundle.cameras) {
            cameras.push_back(count);
            if (!camera.fixed) count += freeParameters(camera.lens);
        }
        second = count;
        if (bundle.cameras.size() > 1) count += kPoseParameters;
        boards = count;
        count += kPoseParameters * bundle.firstFromBoard.size();
    }
    std::vector<std::size_t> cameras;
    std::size_t second = 0;
    std::size_t boards = 0;
    std::size_t count = 0;
};

/// The slopes of one sighting's column and row.
struct Rows {
    static constexpr std::size_t kMost = kCameraParameters + 2 * kPoseParameters;
    std::array<Slope, kMost> x, y;
    std::size_t count = 0;
    void add(std::size_t parameter, const glm::dvec2& slope) {
        x.at(count) = {parameter, slope.x};
        y.at(count) = {parameter, slope.y};
        ++count;
    }
};

/// How a pixel moves with its point in the camera's frame.
struct PointSlope {
    glm::dvec3 x, y;
    [[nodiscard]] glm::dvec2 along(const glm::dvec3& direction) const {
        return {glm::dot(x, direction), glm::dot(y, direction)};
    }
};

PointSlope pointSlope(const calib::CameraModel& camera, const glm::dvec3& p) {
    const glm::dvec2 ray{p.x / p.z, p.y / p.z};
    const glm::dmat2 bend = calib::distortSlope(camera.distortion, ray);
    const glm::dvec2 byX = bend[0] / p.z, byY = bend[1] / p.z;
    const glm::dvec2 byZ = -(byX * ray.x + byY * ray.y);
    const double fx = camera.intrinsics.fx, fy = camera.intrinsics.fy;
    return {fx * glm::dvec3(byX.x, byY.x, byZ.x), fy * glm::dvec3(byX.y, byY.y, byZ.y)};
}

/// By fx fy cx cy and the terms of the distortion, as many as the model frees.
void addCamera(Rows& rows, const BundleCamera& camera, std::size_t first, const glm::dvec3& p) {
    const calib::CameraModel& model = camera.model;
    const glm::dvec2 ray{p.x / p.z, p.y / p.z};
    const glm::dvec2 bent = calib::distort(model.distortion, ray);
    rows.add(first, {bent.x, 0});
    rows.add(first + 1, {0, bent.y});
    rows.add(first + 2, {1, 0});
    rows.add(first + 3, {0, 1});
    const double x = ray.x, y = ray.y, r2 = x * x + y * y;
    const calib::Distortion& k = model.distortion;
    const double denominator = 1 + r2 * (k.k4 + r2 * (k.k5 + r2 * k.k6));
    const double radial = (1 + r2 * (k.k1 + r2 * (k.k2 + r2 * k.k3))) / denominator;
    const glm::dvec2 up = ray / denominator, down = -ray * (radial / denominator);
    const std::array<glm::dvec2, kCameraParameters - kFirstTerm> terms{
        up * r2,
        up * r2 * r2,
        glm::dvec2{2 * x * y, r2 + 2 * y * y},
        glm::dvec2{r2 + 2 * x * x, 2 * x * y},
        up * r2 * r2 * r2,
        down * r2,
        down * r2 * r2,
        down * r2 * r2 * r2};
    const glm::dvec2 focal{model.intrinsics.fx, model.intrinsics.fy};
    for (std::size_t i = kFirstTerm; i < freeParameters(camera.lens); ++i)
        rows.add(first + i, focal * terms.at(i - kFirstTerm));
}

/// By a step of a pose whose rotated point is `turned`; `after` is what follows that pose.
void addPose(Rows& rows, std::size_t first, const PointSlope& slope, const glm::dvec3& turned,
             const glm::dmat3& after) {
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        glm::dvec3 unit{0};
        unit[axis] = 1;
        rows.add(first + static_cast<std::size_t>(axis),
                 slope.along(after * glm::cross(unit, turned)));
    }
    for (glm::length_t axis = 0; axis < 3; ++axis)
        rows.add(first + 3 + static_cast<std::size_t>(axis), slope.along(after[axis]));
}

bool linearise(const Bundle& bundle, const Layout& layout, NormalEquations& equations) {
    for (const Sighting& sighting : bundle.sightings) {
        const calib::RigidTransform& board = bundle.firstFromBoard[sighting.view];
        const BundleCamera& camera = bundle.cameras[sighting.camera];
        const bool isSecond = sighting.camera == 1;
        const glm::dvec3 first = board * sighting.point;
        const glm::dvec3 point = isSecond ? bundle.secondFromFirst * first : first;
        const auto pixel = camera.model.project(point);
        if (!pixel) return false;
        Rows rows;
        const PointSlope slope = pointSlope(camera.model, point);
        if (!camera.fixed) addCamera(rows, camera, layout.cameras[sighting.camera], point);
        if (isSecond)
            addPose(rows, layout.second, slope, point - bundle.secondFromFirst.translation,
                    glm::dmat3(1));
        addPose(rows, layout.boards + kPoseParameters * sighting.view, slope,
                first - board.translation,
                isSecond ? bundle.secondFromFirst.rotation : glm::dmat3(1));
        const glm::dvec2 off = sighting.pixel - *pixel;
        equations.add(std::span(rows.x).first(rows.count), off.x, sighting.weight);
        equations.add(std::span(rows.y).first(rows.count), off.y, sighting.weight);
    }
    return true;
}

calib::RigidTransform steppedBy(const calib::RigidTransform& pose, std::span<const double> step) {
    return stepped(pose, {step[0], step[1], step[2]}, {step[3], step[4], step[5]});
}

Bundle moved(const Bundle& bundle, const Layout& layout, std::span<const double> step) {
    Bundle next = bundle;
    for (std::size_t c = 0; c < next.cameras.size(); ++c) {
        BundleCamera& camera = next.cameras[c];
        if (camera.fixed) continue;
        CameraParameters numbers = parametersOf(camera.model);
        for (std::size_t i = 0; i < freeParameters(camera.lens); ++i)
            numbers.at(i) += step[layout.cameras[c] + i];
        setParameters(camera.model, numbers);
    }
    if (next.cameras.size() > 1)
        next.secondFromFirst = steppedBy(next.secondFromFirst, step.subspan(layout.second));
    for (std::size_t view = 0; view < next.firstFromBoard.size(); ++view)
        next.firstFromBoard[view] = steppedBy(next.firstFromBoard[view],
                                              step.subspan(layout.boards + kPoseParameters * view));
    return next;
}

} // namespace

calib::RigidTransform stepped(const calib::RigidTransform& pose, const glm::dvec3& turn,
                              const glm::dvec3& shift) {
    const double angle = glm::length(turn);
    const glm::dmat3 rotation =
        angle > 0 ? glm::mat3_cast(glm::angleAxis(angle, turn / angle)) : glm::dmat3(1);
    return {rotation * pose.rotation, pose.translation + shift};
}

BundleFit adjust(Bundle& bundle) {
    const Layout layout(bundle);
    BundleFit fit;
    fit.squares = minimise(
        bundle, layout.count,
        [&](const Bundle& state, NormalEquations& equations) {
            return linearise(state, layout, equations);
        },
        [&](const Bundle& state, std::span<const double> step) {
            return moved(state, layout, step);
        });
    fit.covariance = fit.squares.inverse;
    if (fit.covariance && fit.squares.freedom() > 0)
        fit.covariance->scale(fit.squares.cost / fit.squares.freedom());
    return fit;
}

std::optional<glm::dvec2> reprojected(const Bundle& bundle, const Sighting& sighting) {
    const glm::dvec3 first = bundle.firstFromBoard[sighting.view] * sighting.point;
    return bundle.cameras[sighting.camera].model.project(
        sighting.camera == 1 ? bundle.secondFromFirst * first : first);
}

} // namespace autostereo::calibrate
