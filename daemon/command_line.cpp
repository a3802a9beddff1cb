#include "daemon/command_words.hpp"

namespace autostereo::daemon {

namespace {

const std::map<std::string, config::Output> kOutputs{{"window", config::Output::Window},
                                                     {"offscreen", config::Output::Offscreen}};
const std::map<std::string, config::Speed> kSpeeds{{"realtime", config::Speed::Realtime},
                                                   {"max", config::Speed::Max}};
const std::map<std::string, gpu::Method> kMethods(gpu::kMethods.begin(), gpu::kMethods.end());
const std::map<std::string, Picture> kPictures{{"panel", Picture::Panel},
                                               {"quilt", Picture::Quilt},
                                               {"views", Picture::Views},
                                               {"view", Picture::View},
                                               {"depth", Picture::Depth},
                                               {"disparity", Picture::Disparity},
                                               {"2d-plus-depth", Picture::DepthFrame},
                                               {"sbs", Picture::SideBySide},
                                               {"anaglyph", Picture::Anaglyph}};

void addScene(CLI::App& command, SceneOptions& scene) {
    command.add_option(
        "--input", scene.input,
        "Input URI, e.g. sim:person, recording.mkv, kinect2: or v4l2:/dev/video0; run and "
        "render also take scenes: FILE.glb, .gltf, .obj, .ply");
    command.add_option("--color", scene.color,
                       "Input URI whose colour replaces that of --input, e.g. v4l2:serial=1234");
    command.add_option("--display", scene.display, "Display profile: a shipped name or a file");
    command.add_option("--rig", scene.rig, "Cameras' calibration (replaces the input's own)");
    command.add_option("--config", scene.config, "Configuration file");
}

void addRecordRaw(CLI::App& command, std::optional<std::filesystem::path>& file) {
    command.add_option("--record-raw", file,
                       "File of what a kinect2: sends below its decoder, an input again");
}

void addRun(CLI::App& app, RunOptions& run) {
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
    command->add_option("--record", run.record,
                        "Matroska file (Azure Kinect convention) of what the cameras give");
    addRecordRaw(*command, run.recordRaw);
    command->footer("Example: autostereo run --input recording.mkv --display "
                    "looking-glass-portrait --output offscreen --frames 30 --report report.json");
}

void addRecord(CLI::App& app, RecordOptions& record) {
    CLI::App* command = app.add_subcommand("record", "Record cameras without showing anything");
    addScene(*command, record.scene);
    command->add_option("--output", record.output, "Matroska file (Azure Kinect convention)")
        ->required();
    addRecordRaw(*command, record.recordRaw);
    command->add_option("--frames", record.frames, "Stop after so many pairs")
        ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1} << 53));
    command->add_option_function<std::string>("--speed", oneOf(record.speed, kSpeeds, "--speed"),
                                              "realtime (as they come) or max (recordings)");
    command->footer("Example: autostereo record --input sim:person --frames 300 --output p.mkv");
}

void addRender(CLI::App& app, RenderOptions& render) {
    CLI::App* command = app.add_subcommand("render", "Draw one frame to files");
    addScene(*command, render.scene);
    command->add_option("--frame", render.frame, "Which pair of frames, from 0")
        ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{1} << 53));
    command->add_option_function<std::string>(
        "--method", oneOf(render.method, kMethods, "--method"),
        "auto, direct, instanced, multipass, geometry, mrt or hybrid");
    command
        ->add_option_function<std::string>(
            "--as", oneOf(render.as, kPictures, "--as"),
            "panel, quilt, views (a folder of PNGs), view (one eye), depth (16-bit PNG, mm), "
            "disparity (32-bit float TIFF, panel widths), 2d-plus-depth, sbs or anaglyph")
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
    command->add_option("--output", render.output, "PNG or TIFF, or a folder for --as views")
        ->required();
    command->add_flag("--reference", render.reference,
                      "With --as panel: every sub-pixel in double precision, without the GPU's "
                      "search (seconds to minutes)");
    command->footer("Example: autostereo render --input sim:room --display slanted-8view-1080p "
                    "--as quilt --output room_qs4x2a1.78.png");
}

void checkRender(const RenderOptions& render) {
    if (render.reference && render.as != Picture::Panel)
        throw UsageError("--reference: only with --as panel");
    if ((render.eye || render.cameraOffset) && render.as != Picture::View)
        throw UsageError("--eye and --camera-offset go with --as view");
    if (render.eye && render.cameraOffset)
        throw UsageError("--eye and --camera-offset exclude each other");
    if (render.eye && !(render.eye->z > 0))
        throw UsageError("--eye: Z = " + std::to_string(render.eye->z) +
                         " is not in front of the panel (allowed > 0)");
}

void addCheck(CLI::App& app, CheckOptions& check) {
    CLI::App* command =
        app.add_subcommand("check", "Check configurations, displays, rigs and recordings");
    command->add_option("files", check.files, "Files to check")->required();
    command->footer("Example: autostereo check /etc/autostereo/autostereo.toml");
}

void addBench(CLI::App& app, BenchOptions& bench) {
    CLI::App* command =
        app.add_subcommand("bench", "Run time of every method against its error, as a table");
    command
        ->add_option("--suite", bench.request.suite,
                     "quick (some minutes) or full (default: quick)")
        ->check(CLI::IsMember({"quick", "full"}));
    command->add_option("--display", bench.request.display, "Only on this display");
    command->add_option("--input", bench.request.input,
                        "Input URI whose first picture takes the place of the suite's scenes");
    command->add_option("--json", bench.json, "The rows for machines");
    command->add_option("--plot", bench.plot, "Folder for a picture (SVG) of each scene");
    command->footer(
        "Example: autostereo bench --input recording.mkv --json bench.json --plot plots");
}

void addDevices(CLI::App& app, DevicesOptions& devices) {
    CLI::App* command = app.add_subcommand(
        "devices", "List monitors, their links, Looking Glass volumes, cameras, displays, inputs");
    command->add_flag("--json", devices.json, "For machines");
    command->add_option("--root", devices.root, "Where sys, proc and dev are looked for")
        ->group("");
    command->footer("Example: autostereo devices --json");
}

/// Every command's options; the one that was given is filled in.
struct AllOptions {
    RunOptions run;
    RecordOptions record;
    RenderOptions render;
    CheckOptions check;
    DevicesOptions devices;
    InterleaveOptions interleave;
    ViewmapOptions viewmap;
    LookOptions look;
    PatternOptions pattern;
    ImportOptions import;
    BenchOptions bench;
    CalibrateNoiseOptions noise;
    CalibrateCamerasOptions cameras;
    CalibrateRigOptions rig;
    CalibrateTimingOptions timing;
    CalibrateDisplayOptions display;
    LatencyOptions latency;
    ControlOptions control;
};

void addCommands(CLI::App& app, AllOptions& all) {
    addRun(app, all.run);
    addRecord(app, all.record);
    addRender(app, all.render);
    addDisplayCommands(app, all.interleave, all.viewmap, all.look, all.pattern, all.import);
    addLatency(app, all.latency);
    addCheck(app, all.check);
    addDevices(app, all.devices);
    addBench(app, all.bench);
    addCalibrate(app, all.noise, all.cameras, all.rig, all.timing, all.display);
    addControlCommands(app, all.control);
    app.require_subcommand(0, 1);
}

/// The help or version that was asked for instead of a command.
std::optional<Information> parse(CLI::App& app, int argc, const char* const* argv) {
    try {
        app.parse(argc, argv);
        return std::nullopt;
    } catch (const CLI::CallForHelp&) {
        const CLI::App* asked = &app;
        while (!asked->get_subcommands().empty())
            asked = asked->get_subcommands().front();
        return Information{asked->help()};
    } catch (const CLI::CallForVersion& version) {
        return Information{std::string(version.what()) + '\n'};
    } catch (const CLI::ParseError& error) {
        throw UsageError(std::string(error.what()) + " (see autostereo --help)");
    }
}

CommandLine chosen(const CLI::App& app, const AllOptions& all) {
    const std::map<std::string, CommandLine> options{
        {"run", all.run},         {"record", all.record},   {"render", all.render},
        {"check", all.check},     {"devices", all.devices}, {"interleave", all.interleave},
        {"viewmap", all.viewmap}, {"look", all.look},       {"pattern", all.pattern},
        {"import", all.import},   {"bench", all.bench},     {"noise", all.noise},
        {"cameras", all.cameras}, {"rig", all.rig},         {"timing", all.timing},
        {"display", all.display}, {"status", all.control},  {"snapshot", all.control},
        {"reload", all.control},  {"set", all.control},     {"show", all.control},
        {"latency", all.latency}};
    for (const CLI::App* command : app.get_subcommands()) {
        while (!command->get_subcommands().empty()) // calibrate's
            command = command->get_subcommands().front();
        return options.at(command->get_name());
    }
    throw UsageError(
        "no command given (run, record, render, interleave, viewmap, look, pattern, import, "
        "calibrate, check, devices, bench, latency, status, snapshot, reload, set, show): see "
        "autostereo "
        "--help");
}

} // namespace

CommandLine parseCommandLine(int argc, const char* const* argv) {
    CLI::App app{"autostereo: live depth and colour cameras on an autostereoscopic display"};
    app.name("autostereo");
    app.set_version_flag("--version", "autostereo " AUTOSTEREO_VERSION);
    AllOptions all;
    addCommands(app, all);
    if (auto information = parse(app, argc, argv)) return *information;
    checkRender(all.render);
    return chosen(app, all);
}

} // namespace autostereo::daemon
