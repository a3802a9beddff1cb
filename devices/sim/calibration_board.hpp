#pragma once

#include "calib/rigid_transform.hpp"
#include "devices/sim/body.hpp"

namespace autostereo::devices::sim {

/// The whole motion repeats after this many seconds.
constexpr double kBoardPeriodS = 24.0;
/// From the board's centre to its printed face (at z = -kBoardHalfThicknessM of its frame).
constexpr double kBoardHalfThicknessM = 0.004;

/// A chessboard with 9 x 6 inner corners, 60 mm apart, drifting and tilting about 1.2 m in front
/// of the camera. Board frame: origin at the centre, x along the rows, y down the columns, the
/// printed face looks towards -z. A smooth, periodic, pure function of time.
[[nodiscard]] calib::RigidTransform boardPose(double timeSeconds);
[[nodiscard]] Body boardAt(double timeSeconds);

} // namespace autostereo::devices::sim
