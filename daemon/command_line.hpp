#pragma once

#include "config/config.hpp"
#include "daemon/control/control_request.hpp"
#include "tests/bench/views/row.hpp"

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
    std::optional<std::string> color;
    std::optional<std::string> display;
    std::optional<std::filesystem::path> rig;
};

struct RunOptions {
    SceneOptions scene;
    std::optional<config::Output> output;
    bool force = false;
    std::optional<std::uint64_t> frames;
    std::optional<config::Speed> speed;          ///< none: realtime
    std::optional<std::filesystem::path> record; ///< Matroska file
    std::optional<std::filesystem::path> recordRaw;
    std::optional<std::filesystem::path> snapshot;
    std::optional<std::filesystem::path> report;
};

struct RecordOptions {
    SceneOptions scene;
    std::filesystem::path output;
    std::optional<std::filesystem::path> recordRaw;
    std::optional<std::uint64_t> frames;
    std::optional<config::Speed> speed; ///< none: realtime
};

enum class Picture {
    Panel,
    Quilt,
    Views,
    View,
    Depth,
    Disparity,
    DepthFrame,
    SideBySide,
    Anaglyph
};

struct RenderOptions {
    SceneOptions scene;
    std::uint64_t frame = 0;
    std::optional<gpu::Method> method;
    std::optional<Picture> as;
    std::optional<glm::dvec3> eye;          ///< display space, metres
    std::optional<glm::dvec3> cameraOffset; ///< colour camera's axes, metres
    bool reference = false;                 ///< the panel in double precision, on the CPU
    std::filesystem::path output;
};

struct CheckOptions {
    std::vector<std::filesystem::path> files;
};

struct DevicesOptions {
    bool json = false;
    std::filesystem::path root = "/"; ///< where /sys, /proc and /dev lie; tests have their own
};

struct InterleaveOptions {
    std::filesystem::path quilt;
    std::string display;
    std::optional<int> columns, rows; ///< none: from the name, "..._qs8x6a0.75.png"
    std::optional<double> aspect;     ///< of one tile; checked only
    std::optional<int> views;         ///< none: columns x rows, at most the display's
    gpu::ViewFilter filter = gpu::ViewFilter::Nearest;
    std::optional<gpu::TileFilter> texels; ///< none: nearest for nearest, linear for blend
    std::filesystem::path output;
};

struct ViewmapOptions {
    std::string display;
    std::vector<glm::dvec3> eyes;                ///< tracked displays; display space, metres
    bool index = false;                          ///< views instead of phases
    std::optional<std::filesystem::path> texels; ///< PNG of the quilt texels that are shown
    bool json = false;
    std::filesystem::path output;
};

struct LookOptions {
    std::filesystem::path panel;
    std::string display;
    glm::dvec3 eye{0};               ///< display space, metres
    std::optional<double> aperture;  ///< cycles
    std::optional<double> crosstalk; ///< share of light that leaks to either neighbour
    bool json = false;
    std::filesystem::path output;
};

struct PatternOptions {
    std::string name;
    std::string display;
    std::filesystem::path output;
};

struct ImportOptions {
    std::string kind; ///< "looking-glass", "cubevi" displays; "k4a", "opencv", "ros" cameras
    std::filesystem::path file;
    std::optional<std::filesystem::path> color, pose; ///< where a rig comes in several files
    std::optional<std::string> depthSize, colorSize;  ///< "640x576", where the file does not say
    bool millimetres = false;                         ///< translations are
    std::optional<std::string> base;                  ///< shipped display that the file builds on
    std::optional<calib::ViewOrder> order;
    std::filesystem::path output;
};

struct BenchOptions {
    bench::Request request;
    std::optional<std::filesystem::path> json;
    std::optional<std::filesystem::path> plot; ///< folder
};

struct CalibrateNoiseOptions {
    std::string input;
    std::optional<std::filesystem::path> rig;
    std::uint64_t frames = 60;
    bool json = false;
    std::filesystem::path output;
};

/// Pictures of a board, for `calibrate cameras` and `calibrate rig`.
struct BoardOptions {
    std::vector<std::filesystem::path> depth, color;
    std::optional<std::string> input; ///< instead of pictures
    std::uint64_t views = 20;         ///< taken from an input,
    std::uint64_t every = 30;         ///< every so manieth pair
    bool live = false;                ///< or those that are worth it, while somebody watches
    std::string board = "9x6";
    double squareMm = 25;
    std::optional<std::string> dictionary; ///< of a ChArUco board
    double markerMm = 0;
    std::optional<std::filesystem::path> pairs; ///< listed points instead of boards
    std::optional<std::filesystem::path> rig;   ///< the cameras' own numbers, which then stay
    std::optional<std::filesystem::path> opencv;
    bool json = false;
    std::filesystem::path output;
};
/// Photographs of a display, for `calibrate display`.
struct CalibrateDisplayOptions {
    std::string display;                            ///< that is assumed: the panel's model
    std::filesystem::path camera;                   ///< rig file: its colour camera
    std::vector<std::filesystem::path> photographs; ///< four from each place
    bool keys = false;                              ///< by eye instead
    bool json = false;
    std::filesystem::path output;
};
struct CalibrateCamerasOptions : BoardOptions {};
struct CalibrateRigOptions : BoardOptions {};
struct CalibrateTimingOptions : BoardOptions {};

/// How long the panel and a camera in front of it take.
struct LatencyOptions {
    std::optional<std::filesystem::path> config;
    std::optional<std::string> display;
    std::string camera = "sim"; ///< input with a live colour camera; "sim...": a made-up one
    double seconds = 10;
    bool json = false;
};

/// A request to a running program.
struct ControlOptions {
    ControlRequest request;
    std::optional<std::filesystem::path> socket; ///< none: where such sockets lie
    bool json = false;
    std::filesystem::path output; ///< of a snapshot
};

/// --help or --version: the text is printed, exit code 0.
struct Information {
    std::string text;
};

using CommandLine =
    std::variant<RunOptions, RecordOptions, RenderOptions, CheckOptions, DevicesOptions,
                 InterleaveOptions, ViewmapOptions, LookOptions, PatternOptions, ImportOptions,
                 BenchOptions, CalibrateNoiseOptions, CalibrateCamerasOptions, CalibrateRigOptions,
                 CalibrateTimingOptions, CalibrateDisplayOptions, LatencyOptions, ControlOptions,
                 Information>;

/// Throws UsageError.
[[nodiscard]] CommandLine parseCommandLine(int argc, const char* const* argv);

} // namespace autostereo::daemon
