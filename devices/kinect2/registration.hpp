#pragma once

#include "calib/sensor_rig.hpp"
#include "devices/kinect2/calibration.hpp"

namespace autostereo::devices::kinect2 {

inline constexpr int kColorWidth = 1920;
inline constexpr int kColorHeight = 1080;

/// Where the colour camera sees what the depth camera sees along `ray` (x/z, y/z, without
/// distortion) at that depth, by the factory's polynomial; pixel centres at integers. Only the
/// column depends on depth. Reentrant.
[[nodiscard]] glm::dvec2 colorPixel(const ColorCalibration& color, const DepthCamera& depth,
                                    const glm::dvec2& ray, double depthMm);

/// How well the polynomial meets the 644 correspondences that the factory measured on this unit.
/// Whether it noted them before or after taking the depth lens's distortion away is not known:
/// both are tried, the better one is reported.
struct RegistrationCheck {
    int points = 0; ///< that the factory found; without any the rest is 0
    double rmsPx = 0;
    double worstPx = 0;
    bool withoutDistortion = false; ///< the points fit better as already undistorted
};
[[nodiscard]] RegistrationCheck checkRegistration(const ColorCalibration& color,
                                                  const DepthCamera& depth);

/// The same mapping as a camera with a place, a direction and a lens, which the rest of the program
/// works with: least squares over the depth picture from 0.5 to 8 m.
struct FittedRig {
    calib::SensorRig rig;
    double rmsPx = 0; ///< against the polynomial
    double worstPx = 0;
};
[[nodiscard]] FittedRig fitRig(const ColorCalibration& color, const DepthCamera& depth);

} // namespace autostereo::devices::kinect2
