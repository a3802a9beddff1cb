#include "daemon/command_words.hpp"

namespace autostereo::daemon {

namespace {

const std::map<std::string, gpu::ViewFilter> kViewFilters{{"nearest", gpu::ViewFilter::Nearest},
                                                          {"blend", gpu::ViewFilter::Blend}};
const std::map<std::string, gpu::TileFilter> kTexelFilters{{"nearest", gpu::TileFilter::Nearest},
                                                           {"linear", gpu::TileFilter::Linear}};

const std::map<std::string, calib::ViewOrder> kOrders{
    {"left_to_right", calib::ViewOrder::LeftToRight},
    {"right_to_left", calib::ViewOrder::RightToLeft}};

void addDisplay(CLI::App& command, std::string& display) {
    command.add_option("--display", display, "Display profile: a shipped name or a file")
        ->required();
}

glm::dvec3 eyeFrom(const std::vector<double>& numbers) {
    std::optional<glm::dvec3> eye;
    vector3(eye, "--eye")(numbers);
    if (!(eye->z > 0))
        throw UsageError("--eye: Z = " + std::to_string(eye->z) +
                         " is not in front of the panel (allowed > 0)");
    return *eye;
}

void addInterleave(CLI::App& app, InterleaveOptions& options) {
    CLI::App* command =
        app.add_subcommand("interleave", "A quilt of views becomes the display's panel");
    command->add_option("--quilt", options.quilt, "PNG or JPEG; view 0 is its bottom left tile")
        ->required();
    addDisplay(*command, options.display);
    command->add_option("--columns", options.columns, "Tiles across (else from name_qsCxRaA.png)")
        ->check(CLI::Range(1, 100));
    command->add_option("--rows", options.rows, "Tiles up")->check(CLI::Range(1, 100));
    command->add_option("--aspect", options.aspect, "Width / height of a view")
        ->check(CLI::Range(0.01, 100.0));
    command->add_option("--views", options.views, "Where the last tiles are empty")
        ->check(CLI::Range(1, 1000));
    command->add_option_function<std::string>(
        "--filter",
        [&options](const std::string& word) {
            std::optional<gpu::ViewFilter> filter;
            oneOf(filter, kViewFilters, "--filter")(word);
            options.filter = *filter;
        },
        "nearest (view) or blend (two views, as Looking Glass players do)");
    command->add_option_function<std::string>(
        "--texels", oneOf(options.texels, kTexelFilters, "--texels"),
        "nearest or linear (default: nearest with nearest, linear with blend)");
    command->add_option("--output", options.output, "PNG of the panel")->required();
    command->footer("Example: autostereo interleave --quilt castle_qs8x6a0.75.png --display "
                    "looking-glass-portrait --filter blend --output panel.png");
}

void addViewmap(CLI::App& app, ViewmapOptions& options) {
    CLI::App* command = app.add_subcommand(
        "viewmap", "Phase (uint32, 2^32 = one cycle) or view of every sub-pixel, as .npy");
    addDisplay(*command, options.display);
    command
        ->add_option_function<std::vector<double>>(
            "--eye",
            [&options](const std::vector<double>& numbers) {
                for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
                    options.eyes.push_back(eyeFrom({numbers[i], numbers[i + 1], numbers[i + 2]}));
            },
            "X,Y,Z of an eye in display space, metres; repeat for each (tracked displays)")
        ->delimiter(',')
        ->expected(3)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command->add_flag("--index", options.index,
                      "uint16 views, counted from the left; 65535: black");
    command->add_option("--texels", options.texels, "PNG of the quilt texels that the panel shows");
    command->add_flag("--json", options.json, "Counters on standard output");
    command->add_option("--output", options.output, ".npy, H x W x 3 (tracked: E x H x W x 3)")
        ->required();
    command->footer("Example: autostereo viewmap --display slanted-8view-1080p --index --output "
                    "views.npy");
}

void addLook(CLI::App& app, LookOptions& options) {
    CLI::App* command =
        app.add_subcommand("look", "What an eye sees of a panel through the display's optics");
    command->add_option("--panel", options.panel, "PNG of the panel, in its native size")
        ->required();
    addDisplay(*command, options.display);
    command
        ->add_option_function<std::vector<double>>(
            "--eye",
            [&options](const std::vector<double>& numbers) { options.eye = eyeFrom(numbers); },
            "X,Y,Z of the eye in display space, metres")
        ->delimiter(',')
        ->expected(3)
        ->required();
    command->add_option("--aperture", options.aperture, "What a lens or slit shows, in cycles")
        ->check(CLI::Range(0.0, 1.0));
    command
        ->add_option("--crosstalk", options.crosstalk,
                     "Share of the light that leaks to either neighbouring sub-pixel")
        ->check(CLI::Range(0.0, 0.33));
    command->add_flag("--json", options.json, "Figures on standard output");
    command->add_option("--output", options.output, "PNG of what the eye sees")->required();
    command->footer("Example: autostereo look --panel panel.png --display looking-glass-portrait "
                    "--eye 0.03,0,0.5 --output eye.png");
}

void addPattern(CLI::App& app, PatternOptions& options) {
    CLI::App* command = app.add_subcommand("pattern", "Calibration and test pictures");
    command
        ->add_option("name", options.name,
                     "numbers, colors, lines, halves, ramps, calibration-board, or "
                     "calibration-fringes-1 to -3")
        ->required();
    addDisplay(*command, options.display);
    command->add_option("--output", options.output, "PNG of the panel")->required();
    command->footer("Example: autostereo pattern numbers --display barrier-5view --output n.png");
}

void addImport(CLI::App& app, ImportOptions& options) {
    CLI::App* command =
        app.add_subcommand("import", "Another program's calibration becomes a display or rig file");
    command
        ->add_option("kind", options.kind,
                     "Displays: looking-glass, cubevi; cameras: k4a, kinect2 (JSON of "
                     "libfreenect2's parameters: ir, color), opencv, ros")
        ->required();
    command->add_option("file", options.file, "e.g. LKG_calibration/visual.json")->required();
    command->add_option("--base", options.base,
                        "Shipped display that the file builds on (default: by serial and size)");
    command->add_option_function<std::string>(
        "--view-order", oneOf(options.order, kOrders, "--view-order"),
        "left_to_right or right_to_left, where depth looks inside out");
    command->add_option("--output", options.output, "Display or rig file, .toml")->required();
    command->add_option("--color", options.color, "Cameras: the colour camera's file, if apart");
    command->add_option("--pose", options.pose, "Cameras: the file with R and T, if apart");
    command->add_option("--depth-size", options.depthSize,
                        "Cameras: depth pictures' size where the file does not say (k4a: 640x576)");
    command->add_option("--color-size", options.colorSize, "Likewise of colour (k4a: 1280x720)");
    command->add_flag("--millimetres", options.millimetres, "Cameras: translations are in mm");
    command->footer("Example: autostereo import looking-glass visual.json --output mine.toml");
}

} // namespace

void addLatency(CLI::App& app, LatencyOptions& options) {
    CLI::App* command = app.add_subcommand(
        "latency", "How long the panel and a camera that looks at it take: from swap to light and "
                   "to the camera's picture on the host");
    command->add_option("--config", options.config, "Configuration file, TOML");
    command->add_option("--display", options.display,
                        "Display profile: a shipped name or a file (default: recognised)");
    command->add_option("--camera", options.camera,
                        "v4l2:... or another input with colour, which sees the whole panel; sim: "
                        "a made-up one (sim:panel?delay_ms=20&exposure_ms=8)");
    // Each number is shown once, and stands for 50 ms at least.
    command->add_option("--seconds", options.seconds, "How long")->check(CLI::Range(1.0, 50.0));
    command->add_flag("--json", options.json, "Figures on standard output");
    command->footer("Example: autostereo latency --camera v4l2:/dev/video0");
}

void addDisplayCommands(CLI::App& app, InterleaveOptions& interleave, ViewmapOptions& viewmap,
                        LookOptions& look, PatternOptions& pattern, ImportOptions& import) {
    addInterleave(app, interleave);
    addViewmap(app, viewmap);
    addLook(app, look);
    addPattern(app, pattern);
    addImport(app, import);
}

} // namespace autostereo::daemon
