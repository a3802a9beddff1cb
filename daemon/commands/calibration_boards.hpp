#pragma once

#include "calib/solve/depth_board.hpp"
#include "calib/solve/rig_solver.hpp"
#include "daemon/command_line.hpp"

#include <string>
#include <vector>

namespace autostereo::daemon {

/// The board of "9x6" (inner corners), its square and, for ChArUco, its dictionary ("4x4_50") and
/// marker. Throws UsageError.
[[nodiscard]] calibrate::Board boardOf(const BoardOptions& options);

struct FoundBoards {
    calibrate::RigViews views;
    calibrate::PictureSizes sizes;         ///< 0x0: no picture of that camera
    std::vector<std::string> withoutBoard; ///< names of pictures in which none was found
    // Of an input only, as many as views of each camera:
    std::vector<double> depthTimesS, colorTimesS; ///< stamps, as the cameras gave them
    std::vector<calibrate::DepthPicture> depthPictures;
};

/// Looks for the board in the pictures of the options, files or frames of an input. The i-th depth
/// and the i-th colour file are of one moment; of an input, `views` pairs evenly apart. Pictures of
/// one camera have to be of one size. Progress on stderr where that is a terminal. Throws
/// DeviceError, UsageError.
[[nodiscard]] FoundBoards findBoards(const BoardOptions& options);

/// Throws UsageError where the rig's cameras have other picture sizes than those that were seen.
void requireSizesOf(const calib::SensorRig& rig, const calibrate::PictureSizes& seen);

} // namespace autostereo::daemon
