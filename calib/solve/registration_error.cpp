#include "calib/solve/registration_error.hpp"

#include "calib/solve/bundle.hpp"

#include <cmath>
#include <optional>

namespace autostereo::calibrate {

namespace {

constexpr std::size_t kPoseParameters = 6;

/// The rig with its free numbers moved by `step`.
calib::SensorRig movedRig(const calib::SensorRig& rig, const RigFreedom& freedom,
                          std::span<const double> step) {
    calib::SensorRig moved = rig;
    std::size_t at = 0;
    const auto moveCamera = [&](calib::CameraModel& camera, std::size_t free) {
        CameraParameters numbers = parametersOf(camera);
        for (std::size_t i = 0; i < free; ++i)
            numbers.at(i) += step[at++];
        setParameters(camera, numbers);
    };
    moveCamera(moved.depth, freedom.free[0]);
    moveCamera(moved.color, freedom.free[1]);
    moved.colorFromDepth = stepped(moved.colorFromDepth, {step[at], step[at + 1], step[at + 2]},
                                   {step[at + 3], step[at + 4], step[at + 5]});
    return moved;
}

struct Registered {
    glm::dvec2 pixel;
    double rangeM; ///< in the colour camera
};

std::optional<Registered> registered(const calib::SensorRig& rig, const glm::dvec2& depthPixel,
                                     double rangeM) {
    const auto ray = rig.depth.unproject(depthPixel);
    if (!ray) return std::nullopt;
    const glm::dvec3 point = rig.colorFromDepth * (rangeM * glm::dvec3(*ray, 1));
    const auto pixel = rig.color.project(point);
    if (!pixel) return std::nullopt;
    return Registered{*pixel, point.z};
}

/// Variance of the colour's place on the surface, m^2.
std::optional<double> varianceAt(const calib::SensorRig& rig, const RigFreedom& freedom,
                                 const glm::dvec2& depthPixel, double rangeM) {
    const auto here = registered(rig, depthPixel, rangeM);
    if (!here) return std::nullopt;
    const std::size_t count = freedom.covariance.size();
    std::vector<glm::dvec2> slopes(count);
    std::vector<double> step(count, 0);
    for (std::size_t i = 0; i < count; ++i) {
        // A thousandth of the parameter's own uncertainty: linear, and far above rounding.
        const double size = 1e-3 * std::sqrt(freedom.covariance.at(i, i));
        if (!(size > 0)) continue;
        step[i] = size;
        const auto up = registered(movedRig(rig, freedom, step), depthPixel, rangeM);
        step[i] = -size;
        const auto down = registered(movedRig(rig, freedom, step), depthPixel, rangeM);
        step[i] = 0;
        if (!up || !down) return std::nullopt;
        slopes[i] = (up->pixel - down->pixel) / (2 * size);
    }
    double squarePx = 0;
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = 0; j < count; ++j)
            squarePx += freedom.covariance.at(i, j) *
                        (slopes[i].x * slopes[j].x + slopes[i].y * slopes[j].y);
    const double metresPerPx = here->rangeM / rig.color.intrinsics.fx;
    return squarePx * metresPerPx * metresPerPx;
}

} // namespace

std::vector<RegistrationError> registrationErrors(const calib::SensorRig& rig,
                                                  const RigFreedom& freedom,
                                                  std::span<const double> rangesM) {
    constexpr int kColumns = 7, kRows = 5;
    constexpr double kSigmas95 = 1.959964, kMmPerM = 1e3;
    std::vector<RegistrationError> errors;
    if (freedom.covariance.size() != freedom.free[0] + freedom.free[1] + kPoseParameters)
        return errors;
    for (const double range : rangesM) {
        double sum = 0;
        int count = 0;
        for (int row = 0; row < kRows; ++row)
            for (int column = 0; column < kColumns; ++column) {
                const glm::dvec2 pixel{(column + 0.5) / kColumns * rig.depth.intrinsics.width - 0.5,
                                       (row + 0.5) / kRows * rig.depth.intrinsics.height - 0.5};
                const auto variance = varianceAt(rig, freedom, pixel, range);
                if (!variance) continue;
                sum += *variance;
                ++count;
            }
        if (count > 0) errors.push_back({range, kSigmas95 * kMmPerM * std::sqrt(sum / count)});
    }
    return errors;
}

} // namespace autostereo::calibrate
