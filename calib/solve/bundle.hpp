#pragma once

#include "calib/camera_model.hpp"
#include "calib/rigid_transform.hpp"
#include "calib/solve/least_squares.hpp"
#include "calib/solve/lens_model.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace autostereo::calibrate {

/// One known point of the board as one camera saw it.
struct Sighting {
    std::size_t view = 0;
    std::size_t camera = 0; ///< 0 or 1
    glm::dvec3 point{0};    ///< board's frame, metres
    glm::dvec2 pixel{0};
    double weight = 1; ///< 1 / variance, 1/px^2
};

struct BundleCamera {
    calib::CameraModel model;
    LensModel lens = LensModel::Five;
    bool fixed = false; ///< its numbers are known
};

/// All that is unknown when one or two cameras look at a board: cameras, how the second stands to
/// the first, and where the board was in each view.
struct Bundle {
    std::vector<BundleCamera> cameras; ///< one or two
    calib::RigidTransform secondFromFirst;
    std::vector<calib::RigidTransform> firstFromBoard;
    std::vector<Sighting> sightings;
};

struct BundleFit {
    LeastSquaresFit squares;
    /// Of the free parameters in this order: those of each camera that is not fixed, the second
    /// camera's pose (rotation vector, then translation), the boards' poses. Scaled by the residual
    /// variance, so that corners' noise need not be known. None: the views leave something open.
    std::optional<SymmetricMatrix> covariance;
};

/// Least squares over all of it; `bundle` is the start and becomes the answer. Analytic
/// derivatives; rotations are stepped by a rotation vector from the left.
BundleFit adjust(Bundle& bundle);

/// Where the sighting's point falls after the model; none: behind the camera.
[[nodiscard]] std::optional<glm::dvec2> reprojected(const Bundle& bundle, const Sighting& sighting);

/// Root mean square distance in pixels, as OpenCV counts it, over the sightings that `counts`
/// takes; NaN for none.
template<class Counts>
[[nodiscard]] double rmsPixels(const Bundle& bundle, const Counts& counts) {
    double squares = 0;
    std::size_t count = 0;
    for (const Sighting& sighting : bundle.sightings) {
        if (!counts(sighting)) continue;
        const auto pixel = reprojected(bundle, sighting);
        if (!pixel) return std::numeric_limits<double>::infinity();
        const glm::dvec2 off = *pixel - sighting.pixel;
        squares += off.x * off.x + off.y * off.y;
        ++count;
    }
    return std::sqrt(squares / static_cast<double>(count));
}

/// R' = exp(turn) R, t' = t + shift.
[[nodiscard]] calib::RigidTransform stepped(const calib::RigidTransform& pose,
                                            const glm::dvec3& turn, const glm::dvec3& shift);

} // namespace autostereo::calibrate
