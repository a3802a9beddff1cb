#include "daemon/command_line.hpp"

#include <CLI/CLI.hpp>

#include <array>
#include <cmath>
#include <map>
#include <span>

namespace autostereo::daemon {

namespace {

const std::map<std::string, config::Output> kOutputs{{"window", config::Output::Window},
                                                     {"offscreen", config::Output::Offscreen}};
const std::map<std::string, config::Speed> kSpeeds{{"realtime", config::Speed::Realtime},
                                                   {"max", config::Speed::Max}};
const std::map<std::string, gpu::Method> kMethods{{"instanced", gpu::Method::Instanced},
                                                  {"multipass", gpu::Method::Multipass}};
const std::map<std::string, Picture> kPictures{{"panel", Picture::Panel},
                                               {"quilt", Picture::Quilt},
                                               {"views", Picture::Views},
                                               {"view", Picture::View},
                                               {"depth", Picture::Depth}};

// Known words of the command line whose work is not in this version yet.
constexpr std::array kLaterCommands{"interleave", "viewmap", "look",  "pattern", "import",
                                    "calibrate",  "record",  "bench", "status",  "snapshot",
                                    "reload",     "set",     "show"};
constexpr std::array kLaterPictures{"2d-plus-depth", "sbs", "anaglyph", "disparity"};
constexpr std::array kLaterMethods{"auto", "direct", "geometry", "mrt", "hybrid"};

template<class Words>
bool contains(const Words& words, std::string_view word) {
    return std::find(std::begin(words), std::end(words), word) != std::end(words);
}

[[noreturn]] void notInThisVersion(const std::string& what) {
    throw UsageError(what + ": not in this version");
}

/// A word out of a table; words of later versions are told apart from nonsense.
template<class Value>
auto oneOf(std::optional<Value>& to, const std::map<std::string, Value>& table, const char* option,
           std::span<const char* const> later = {}) {
    return [&to, &table, option, later](const std::string& word) {
        if (contains(later, word)) notInThisVersion(std::string(option) + " " + word);
        const auto found = table.find(word);
        if (found == table.end()) {
            std::string allowed;
            for (const auto& [name, value] : table)
                allowed += (allowed.empty() ? "" : ", ") + name;
            throw UsageError(std::string(option) + ": " + word + " is not known (allowed " +
                             allowed + ")");
        }
        to = found->second;
    };
}

auto vector3(std::optional<glm::dvec3>& to, const char* option) {
    return [&to, option](const std::vector<double>& numbers) {
        for (const double number : numbers)
            if (!std::isfinite(number))
                throw UsageError(std::string(option) + ": " + std::to_string(number) +
                                 " is not a length in metres");
        to = glm::dvec3{numbers[0], numbers[1], numbers[2]};
    };
}

void addScene(CLI::App& command, SceneOptions& scene) {
    command.add_option("--input", scene.input, "Input URI, e.g. sim:person or recording.mkv");
    command.add_option("--display", scene.display, "Display profile: a shipped name or a file");
    command.add_option("--rig", scene.rig, "Cameras' calibration (replaces the input's own)");
    command.add_option("--config", scene.config, "Configuration file");
}

void addLater(CLI::App& command, const char* option) {
    command
        .add_option_function<std::string>(
            option, [option](const std::string&) { notInThisVersion(option); })
        ->expected(0, 1)
        ->group("");
}

CLI::App* addRun(CLI::App& app, RunOptions& run) {
    CLI::App* command = app.add_subcommand("run", "Drive the display, live or from a recording");
    addScene(*command, run.scene);
    command->add_option_function<std::string>("--output", oneOf(run.output, kOutputs, "--output"),
                                              "window or offscreen");
    command->add_flag("--force", run.force, "Show even on a monitor in another mode");
    command->add_option("--frames", run.frames, "Stop after so many frames")
        ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1} << 53));
    command->add_option_function<std::string>(
        "--speed", oneOf(run.speed, kSpeeds, "--speed"),
        "realtime (as recorded; late frames are dropped) or max (every frame, repeatable)");
    command->add_option("--snapshot", run.snapshot, "PNG of the panel at the end");
    command->add_option("--report", run.report, "JSON with accounts, stage times and latency");
    addLater(*command, "--record");
    addLater(*command, "--record-raw");
    command->footer("Example: autostereo run --input recording.mkv --display "
                    "looking-glass-portrait --output offscreen --frames 30 --report report.json");
    return command;
}

CLI::App* addRender(CLI::App& app, RenderOptions& render) {
    CLI::App* command = app.add_subcommand("render", "Draw one frame to files");
    addScene(*command, render.scene);
    command->add_option("--frame", render.frame, "Which pair of frames, from 0")
        ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{1} << 53));
    command->add_option_function<std::string>(
        "--method", oneOf(render.method, kMethods, "--method", kLaterMethods),
        "instanced or multipass");
    command
        ->add_option_function<std::string>(
            "--as", oneOf(render.as, kPictures, "--as", kLaterPictures),
            "panel, quilt, views (a folder of PNGs), view (one eye) or depth (16-bit PNG, mm)")
        ->required();
    command
        ->add_option_function<std::vector<double>>("--eye", vector3(render.eye, "--eye"),
                                                   "X,Y,Z of an eye in display space, metres")
        ->delimiter(',')
        ->expected(3);
    command
        ->add_option_function<std::vector<double>>(
            "--camera-offset", vector3(render.cameraOffset, "--camera-offset"),
            "X,Y,Z that the colour camera is moved by along its axes, metres")
        ->delimiter(',')
        ->expected(3);
    command->add_option("--output", render.output, "PNG, or a folder for --as views")->required();
    command->add_flag_callback("--reference", [] { notInThisVersion("--reference"); })->group("");
    command->footer("Example: autostereo render --input sim:room --display slanted-8view-1080p "
                    "--as quilt --output room_qs4x2a1.78.png");
    return command;
}

CommandLine chosen(const CLI::App& app, const RunOptions& run, const RenderOptions& render,
                   const CheckOptions& check, const DevicesOptions& devices) {
    if (app.got_subcommand("render")) {
        if ((render.eye || render.cameraOffset) && render.as != Picture::View)
            throw UsageError("--eye and --camera-offset go with --as view");
        if (render.eye && render.cameraOffset)
            throw UsageError("--eye and --camera-offset exclude each other");
        if (render.eye && !(render.eye->z > 0))
            throw UsageError("--eye: Z = " + std::to_string(render.eye->z) +
                             " is not in front of the panel (allowed > 0)");
        return render;
    }
    if (app.got_subcommand("check")) return check;
    if (app.got_subcommand("devices")) return devices;
    if (app.got_subcommand("run")) return run;
    throw UsageError("no command given (run, render, check, devices): see autostereo --help");
}

} // namespace

CommandLine parseCommandLine(int argc, const char* const* argv) {
    CLI::App app{"autostereo: live depth and colour cameras on an autostereoscopic display"};
    app.name("autostereo");
    app.set_version_flag("--version", "autostereo " AUTOSTEREO_VERSION);
    if (argc > 1 && contains(kLaterCommands, argv[1])) notInThisVersion(argv[1]);

    RunOptions run;
    RenderOptions render;
    CheckOptions check;
    DevicesOptions devices;
    addRun(app, run);
    addRender(app, render);
    CLI::App* checkCommand =
        app.add_subcommand("check", "Check configurations, displays, rigs and recordings");
    checkCommand->add_option("files", check.files, "Files to check")->required();
    checkCommand->footer("Example: autostereo check /etc/autostereo/autostereo.toml");
    CLI::App* devicesCommand = app.add_subcommand(
        "devices", "List monitors, their links, Looking Glass volumes, displays, inputs");
    devicesCommand->add_flag("--json", devices.json, "For machines");
    devicesCommand->add_option("--root", devices.root, "Where sys, proc and dev are looked for")
        ->group("");
    devicesCommand->footer("Example: autostereo devices --json");
    app.require_subcommand(0, 1);
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        const auto given = app.get_subcommands();
        return Information{(given.empty() ? &app : given.front())->help()};
    } catch (const CLI::CallForVersion& version) {
        return Information{std::string(version.what()) + '\n'};
    } catch (const CLI::ParseError& error) {
        throw UsageError(std::string(error.what()) + " (see autostereo --help)");
    }
    return chosen(app, run, render, check, devices);
}

} // namespace autostereo::daemon
