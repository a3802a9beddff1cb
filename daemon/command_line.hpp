#pragma once

#include "config/config.hpp"

#include <glm/vec3.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace autostereo::daemon {

/// Words of the command line that cannot be taken; one line, exit code 2.
class UsageError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// What `run` and `render` share; unset options keep what the configuration says.
struct SceneOptions {
    std::optional<std::filesystem::path> config;
    std::optional<std::string> input;
    std::optional<std::string> display;
    std::optional<std::filesystem::path> rig;
};

struct RunOptions {
    SceneOptions scene;
    std::optional<config::Output> output;
    bool force = false;
    std::optional<std::uint64_t> frames;
    std::optional<config::Speed> speed; ///< none: realtime
    std::optional<std::filesystem::path> snapshot;
    std::optional<std::filesystem::path> report;
};

enum class Picture { Panel, Quilt, Views, View, Depth };

struct RenderOptions {
    SceneOptions scene;
    std::uint64_t frame = 0;
    std::optional<gpu::Method> method;
    std::optional<Picture> as;
    std::optional<glm::dvec3> eye;          ///< display space, metres
    std::optional<glm::dvec3> cameraOffset; ///< colour camera's axes, metres
    std::filesystem::path output;
};

struct CheckOptions {
    std::vector<std::filesystem::path> files;
};

struct DevicesOptions {
    bool json = false;
    std::filesystem::path root = "/"; ///< where /sys, /proc and /dev lie; tests have their own
};

/// --help or --version: the text is printed, exit code 0.
struct Information {
    std::string text;
};

using CommandLine =
    std::variant<RunOptions, RenderOptions, CheckOptions, DevicesOptions, Information>;

/// Throws UsageError. Commands and options of later versions are known and say so.
[[nodiscard]] CommandLine parseCommandLine(int argc, const char* const* argv);

} // namespace autostereo::daemon
