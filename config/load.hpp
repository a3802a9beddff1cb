#pragma once

#include "config/config.hpp"

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace autostereo::config {

/// One line: `file:line:column: key: what is wrong (allowed ...)`.
class ConfigError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Configuration file -> Config. Missing keys keep the value of the embedded default.toml;
/// unknown keys, wrong types and values out of range throw ConfigError.
[[nodiscard]] Config loadConfig(const std::filesystem::path& file);
/// The embedded default.toml.
[[nodiscard]] Config defaultConfig();

/// The configuration with one of the settings that a running program takes: scale, focus, method,
/// brightness or mode, with the ranges that files have. Throws ConfigError.
[[nodiscard]] Config changed(Config config, const std::string& name, const std::string& value);

/// Display profile by file path (a display file, or a Looking Glass' or CubeVi's own calibration,
/// .json), or by name from the embedded profiles. Throws ConfigError; no physical number has a
/// default.
[[nodiscard]] calib::DisplayProfile loadDisplay(const std::string& nameOrFile);
/// The same from a text; `file` names it in messages, and by its extension says what it is: a
/// display file, .toml, or a vendor's calibration, .json.
[[nodiscard]] calib::DisplayProfile displayFromText(const std::string& file, std::string_view text);
/// Names of the embedded profiles, sorted.
[[nodiscard]] std::vector<std::string> displayNames();

/// Rig file (TOML, or camera.json by its extension) -> SensorRig. Throws ConfigError.
[[nodiscard]] calib::SensorRig loadRig(const std::filesystem::path& file);
/// The embedded rigs/example.toml: nominal cameras for inputs without a calibration.
[[nodiscard]] calib::SensorRig exampleRig();

/// What a TOML or JSON file is, by its content: a configuration, a display or a rig.
enum class FileKind { Config, Display, Rig };
[[nodiscard]] FileKind kindOf(const std::filesystem::path& file);

} // namespace autostereo::config
