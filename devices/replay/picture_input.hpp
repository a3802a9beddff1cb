#pragma once

#include "devices/input.hpp"
#include "devices/replay/calibration_files.hpp"
#include "devices/replay/picture_source.hpp"
#include "devices/uri.hpp"

#include <optional>
#include <string>
#include <vector>

namespace autostereo::devices {

/// The files of an input made of pictures, in order of time; a list may be empty.
struct PictureLists {
    std::vector<Picture> depth;
    std::vector<Picture> color;
    double depthUnitM = 0.001;
    Duration nominalPeriod{0};
};

/// Makes an Input of picture files. Cameras: `rig` where given, else `cameras`, else a nominal pair
/// that sees registered pictures, with a warning. Throws DeviceError where both lists are empty.
[[nodiscard]] Input inputFromPictures(const Uri& uri, const std::string& kind, PictureLists lists,
                                      const std::optional<calib::SensorRig>& rig,
                                      const std::optional<CameraFile>& cameras);

/// `tum:DIR?camera=FILE`: a folder of the TUM RGB-D benchmark (rgb.txt, depth.txt). Listed files
/// that are not there are left out. Depth is registered to the colour camera as it is, distortion
/// included, so both share one model: FILE's, else the published one of the freiburg set.
[[nodiscard]] Input openTum(const Uri& uri, const std::optional<calib::SensorRig>& rig);

/// `seq:DIR?fps=30`: frame-N.color.(jpg|png) with frame-N.depth.png, or N.(jpg|png) with 16-bit
/// N.png; camera.json in the folder is used. Frame N is at (N - first N) / fps.
[[nodiscard]] Input openSequence(const Uri& uri, const std::optional<calib::SensorRig>& rig);

/// `rgbd:color.png,depth.png,camera.json`: one pair; one picture and the camera may be left empty.
[[nodiscard]] Input openRgbd(const Uri& uri, const std::optional<calib::SensorRig>& rig);

} // namespace autostereo::devices
