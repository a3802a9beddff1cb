#pragma once

#include "devices/v4l2/camera_format.hpp"
#include "devices/v4l2/find_cameras.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace autostereo::devices::v4l2 {

/// A camera, what it can do, and what is wrong, in sentences with what to do.
struct CameraReport {
    CameraNode node;
    std::vector<Mode> modes; ///< those that we can show, each at its fastest
    std::vector<std::string> problems;
};

/// Every camera below `root` (where /sys, /proc and /dev lie); each node is opened for a moment,
/// which disturbs nobody who streams from it. Nodes that open and capture nothing are left out.
[[nodiscard]] std::vector<CameraReport> reportCameras(const std::filesystem::path& root = "/");

} // namespace autostereo::devices::v4l2
