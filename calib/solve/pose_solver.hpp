#pragma once

#include "calib/solve/pose_start.hpp"
#include "calib/solve/symmetric_matrix.hpp"

#include <span>
#include <vector>

namespace autostereo::calibrate {

/// A camera's pose from points and pixels (de Sorbier 2010, section II.B: the depth camera's own
/// 3-D points against the colour camera's picture).
struct PoseFit {
    calib::RigidTransform cameraFromPoints;
    std::vector<std::size_t> inliers; ///< places in the list
    double rmsPx = 0;                 ///< over the inliers
    /// Of the rotation vector (rad) and the translation (m), scaled by the residuals.
    SymmetricMatrix covariance;
};

/// Random sample consensus, then weighted least squares over what agrees within `tolerancePx`, the
/// set of which is renewed until it stays. Needs six pairs that agree; throws Refusal with how many
/// do. Deterministic.
[[nodiscard]] PoseFit solvePose(const calib::CameraModel& camera, std::span<const PointPixel> pairs,
                                double tolerancePx);
/// The same from a pose that is known roughly. Of points in a plane, which from afar look nearly
/// the same in two poses: random samples would choose either.
[[nodiscard]] PoseFit settlePose(const calib::CameraModel& camera,
                                 std::span<const PointPixel> pairs, double tolerancePx,
                                 const calib::RigidTransform& start);

} // namespace autostereo::calibrate
