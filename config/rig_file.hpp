#pragma once

#include "calib/sensor_rig.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace autostereo::config {

/// What a rig file holds; a file with one camera, or without the transform, is a step on the way to
/// a rig.
struct RigFile {
    std::optional<calib::CameraModel> depth;
    std::optional<calib::CameraModel> color;
    std::optional<calib::RigidTransform> colorFromDepth;
    std::string provenance;
    /// How good the numbers are, by the keys of `qualityKeys`.
    std::map<std::string, double> quality;
    std::vector<std::string> warnings; ///< what the calibration said
    double colorLateS = 0;             ///< as calib::SensorRig's
};

/// One number of [quality] and how it is told to people.
struct QualityKey {
    std::string_view key;
    const char* form; ///< printf's, with one double
};
[[nodiscard]] const std::vector<QualityKey>& qualityKeys();

/// Reads a rig file, whole or in part; throws ConfigError. At least one camera is there.
[[nodiscard]] RigFile readRigFile(const std::filesystem::path& file);
/// The rig that a text gives; what is missing is an error. `name` is the file in messages.
[[nodiscard]] calib::SensorRig wholeRig(const std::string& name, std::string_view text);
/// The text that reads back to the same.
[[nodiscard]] std::string rigText(const RigFile& rig);
/// What is in it and how good it is, a line each.
[[nodiscard]] std::vector<std::string> explained(const RigFile& rig);

} // namespace autostereo::config
