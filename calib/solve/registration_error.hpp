#pragma once

#include "calib/sensor_rig.hpp"
#include "calib/solve/lens_model.hpp"
#include "calib/solve/symmetric_matrix.hpp"

#include <array>
#include <span>
#include <vector>

namespace autostereo::calibrate {

/// What the numbers of a rig were found with, for `registrationErrors`.
struct RigFreedom {
    std::array<std::size_t, 2> free{}; ///< parameters of depth and colour camera; 0: known
    /// Of those, then the rotation vector and the translation.
    SymmetricMatrix covariance;
};

struct RegistrationError {
    double rangeM = 0;
    double mm95 = 0; ///< the colour of a surface there lies this far off at most (95 %)
};

/// How far the calibration's own uncertainty moves the colour on a surface, root mean square over a
/// grid of the depth picture, times 1.96: its covariance carried through depth pixel -> point ->
/// colour pixel. Ranges along the depth camera's axis. Pixels that either camera cannot see count
/// not; a range where none is left is left out.
[[nodiscard]] std::vector<RegistrationError> registrationErrors(const calib::SensorRig& rig,
                                                                const RigFreedom& freedom,
                                                                std::span<const double> rangesM);

/// At these ranges it is reported.
inline constexpr std::array kReportedRangesM{0.5, 1.0, 2.0, 3.0};

} // namespace autostereo::calibrate
