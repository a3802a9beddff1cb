#pragma once

#include "calib/solve/rig_solver.hpp"
#include "config/rig_file.hpp"
#include "daemon/command_line.hpp"
#include "daemon/commands/calibration_boards.hpp"

namespace autostereo::daemon {

/// A camera's numbers and their worth, into the file's; `prefix` "depth" or "color".
void addCamera(config::RigFile& file, const char* prefix,
               const calibrate::CameraCalibration& found);
void addRig(config::RigFile& file, const calibrate::RigCalibration& found);
/// What the depth camera's measurements of the board say, where there are any; `file` has its lens.
void addDepthBias(config::RigFile& file, const FoundBoards& found, const calibrate::Board& board);

/// Models tried and views rejected, for people.
void printCamera(const char* which, const calibrate::CameraCalibration& found);

/// Throws UsageError where --output is no rig file; before the work begins.
void requireRigFile(const BoardOptions& options);
/// Writes the rig, an old file being kept as FILE.old, and what `options` ask for besides; prints
/// what is in it, or JSON.
void deliver(const config::RigFile& file, const BoardOptions& options);

} // namespace autostereo::daemon
