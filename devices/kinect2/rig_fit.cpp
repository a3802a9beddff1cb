#include "devices/kinect2/registration.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace autostereo::devices::kinect2 {

namespace {

/// fx fy cx cy, k1 k2 p1 p2 k3, rotation vector, translation in metres.
constexpr std::size_t kUnknowns = 15;
using Unknowns = std::array<double, kUnknowns>;

glm::dmat3 rotationBy(const glm::dvec3& turn) {
    const double angle = std::sqrt(turn.x * turn.x + turn.y * turn.y + turn.z * turn.z);
    const glm::dmat3 cross{0, turn.z, -turn.y, -turn.z, 0, turn.x, turn.y, -turn.x, 0};
    if (angle < 1e-12) return glm::dmat3(1.0) + cross;
    return glm::dmat3(1.0) + std::sin(angle) / angle * cross +
           (1 - std::cos(angle)) / (angle * angle) * (cross * cross);
}

calib::SensorRig rigOf(const Unknowns& u, const DepthCamera& depth) {
    calib::SensorRig rig;
    rig.depth = depth.model;
    rig.color.intrinsics = {kColorWidth, kColorHeight, u[0], u[1], u[2], u[3]};
    auto& lens = rig.color.distortion;
    lens.k1 = u[4];
    lens.k2 = u[5];
    lens.p1 = u[6];
    lens.p2 = u[7];
    lens.k3 = u[8];
    rig.colorFromDepth = {rotationBy({u[9], u[10], u[11]}), {u[12], u[13], u[14]}};
    rig.provenance = "the camera's own calibration";
    return rig;
}

struct Correspondence {
    glm::dvec3 point; ///< metres, depth camera
    glm::dvec2 pixel; ///< of the colour camera
};

std::vector<Correspondence> correspondences(const ColorCalibration& color,
                                            const DepthCamera& depth) {
    constexpr int kStep = 24;
    std::vector<Correspondence> result;
    for (int y = kStep / 2; y < kHeight; y += kStep)
        for (int x = kStep / 2; x < kWidth; x += kStep) {
            const auto ray = depth.model.unproject({x, y});
            if (!ray) continue;
            for (const double z : {0.5, 0.8, 1.5, 3.0, 8.0})
                result.push_back(
                    {{ray->x * z, ray->y * z, z}, colorPixel(color, depth, *ray, z * 1000)});
        }
    return result;
}

/// Two residuals for each correspondence, pixels.
std::vector<double> residuals(const Unknowns& unknowns, const DepthCamera& depth,
                              const std::vector<Correspondence>& all) {
    constexpr double kUnseen = 1e4; // behind the camera or outside of the model
    const calib::SensorRig rig = rigOf(unknowns, depth);
    std::vector<double> result;
    result.reserve(2 * all.size());
    for (const auto& [point, pixel] : all) {
        const auto seen = rig.color.project(rig.colorFromDepth * point);
        result.push_back(seen ? seen->x - pixel.x : kUnseen);
        result.push_back(seen ? seen->y - pixel.y : kUnseen);
    }
    return result;
}

double sumOfSquares(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values)
        sum += value * value;
    return sum;
}

/// The normal equations of one step.
struct Normal {
    std::array<Unknowns, kUnknowns> matrix{};
    Unknowns right{};
};

Normal normalAt(const Unknowns& unknowns, const std::vector<double>& now, const DepthCamera& depth,
                const std::vector<Correspondence>& all) {
    constexpr double kSmall = 1e-6; // of every unknown's natural size, which is 1 but for pixels
    std::array<std::vector<double>, kUnknowns> slopes;
    for (std::size_t i = 0; i < kUnknowns; ++i) {
        Unknowns moved = unknowns;
        const double step = kSmall * std::max(1.0, std::abs(unknowns[i]));
        moved[i] += step;
        slopes[i] = residuals(moved, depth, all);
        for (std::size_t k = 0; k < now.size(); ++k)
            slopes[i][k] = (slopes[i][k] - now[k]) / step;
    }
    Normal normal;
    for (std::size_t i = 0; i < kUnknowns; ++i)
        for (std::size_t k = 0; k < now.size(); ++k) {
            normal.right[i] -= slopes[i][k] * now[k];
            for (std::size_t j = 0; j < kUnknowns; ++j)
                normal.matrix[i][j] += slopes[i][k] * slopes[j][k];
        }
    return normal;
}

/// Gaussian elimination; the damped matrix is positive definite, so no pivoting.
Unknowns solve(Normal normal, double damping) {
    auto& [a, b] = normal;
    for (std::size_t i = 0; i < kUnknowns; ++i)
        a[i][i] += damping * a[i][i] + 1e-12;
    for (std::size_t i = 0; i < kUnknowns; ++i)
        for (std::size_t row = i + 1; row < kUnknowns; ++row) {
            const double factor = a[row][i] / a[i][i];
            for (std::size_t j = i; j < kUnknowns; ++j)
                a[row][j] -= factor * a[i][j];
            b[row] -= factor * b[i];
        }
    Unknowns step{};
    for (std::size_t i = kUnknowns; i-- > 0;) {
        double sum = b[i];
        for (std::size_t j = i + 1; j < kUnknowns; ++j)
            sum -= a[i][j] * step[j];
        step[i] = sum / a[i][i];
    }
    return step;
}

/// Levenberg and Marquardt's method.
Unknowns minimise(Unknowns unknowns, const DepthCamera& depth,
                  const std::vector<Correspondence>& all) {
    constexpr int kMostSteps = 200; // also those that lead nowhere
    constexpr double kMostDamping = 1e9, kConverged = 1e-12;
    double damping = 1e-3;
    std::vector<double> now = residuals(unknowns, depth, all);
    for (int step = 0; step < kMostSteps && damping < kMostDamping; ++step) {
        const double before = sumOfSquares(now);
        const Unknowns change = solve(normalAt(unknowns, now, depth, all), damping);
        Unknowns moved = unknowns;
        for (std::size_t i = 0; i < kUnknowns; ++i)
            moved[i] += change[i];
        auto there = residuals(moved, depth, all);
        const double after = sumOfSquares(there);
        if (!(after < before)) {
            damping *= 10;
            continue;
        }
        unknowns = moved;
        now = std::move(there);
        damping *= 0.1;
        if (before - after < kConverged * before) break;
    }
    return unknowns;
}

} // namespace

FittedRig fitRig(const ColorCalibration& color, const DepthCamera& depth) {
    const auto all = correspondences(color, depth);
    Unknowns start{color.focal, color.focal, color.cx, color.cy};
    start[12] = color.displacementMm * 1e-3;
    const Unknowns best = minimise(start, depth, all);
    FittedRig result;
    result.rig = rigOf(best, depth);
    const auto left = residuals(best, depth, all);
    for (std::size_t i = 0; i < left.size(); i += 2)
        result.worstPx = std::max(result.worstPx, std::hypot(left[i], left[i + 1]));
    if (!all.empty())
        result.rmsPx = std::sqrt(sumOfSquares(left) / static_cast<double>(all.size()));
    return result;
}

} // namespace autostereo::devices::kinect2
