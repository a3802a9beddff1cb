#pragma once

#include "calib/camera_model.hpp"
#include "calib/rigid_transform.hpp"
#include "calib/solve/board.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

// First guesses that least squares start from. Pure; reentrant.

namespace autostereo::calibrate {

/// Focal lengths from the boards' homographies (Zhang 2000), the centre in the middle, no
/// distortion. None where the boards do not tell: all of them parallel to the picture.
[[nodiscard]] std::optional<calib::CameraModel>
startingCamera(const Board& board, std::span<const BoardView> views, int width, int height);

/// Where the board stands in front of a camera (infinitesimal plane-based pose, Collins and Bartoli
/// 2014). Needs four corners that are not in line.
[[nodiscard]] std::optional<calib::RigidTransform>
startingPose(const calib::CameraModel& camera, const Board& board, const BoardView& view);

/// A point in some other frame (metres) and the pixel in which the camera sees it.
struct PointPixel {
    glm::dvec3 point{0};
    glm::dvec2 pixel{0};
    double weight = 1; ///< 0 to 1: how far the point is to be trusted
};

struct RansacPose {
    calib::RigidTransform cameraFromPoints;
    std::vector<std::size_t> inliers; ///< places in the list
};
/// Random sample consensus over minimal sets; same list, same answer. An inlier falls within
/// `tolerancePx`. None with fewer than six pairs, or where no six agree.
[[nodiscard]] std::optional<RansacPose>
ransacPose(const calib::CameraModel& camera, std::span<const PointPixel> pairs, double tolerancePx);

} // namespace autostereo::calibrate
