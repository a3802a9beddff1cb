#include "daemon/command_words.hpp"

namespace autostereo::daemon {

namespace {

void addNoise(CLI::App& calibrate, CalibrateNoiseOptions& noise) {
    CLI::App* command = calibrate.add_subcommand(
        "noise", "The depth camera's noise, from a still scene, as a configuration file");
    command->add_option("--input", noise.input, "Input URI of a scene in which nothing moves")
        ->required();
    command->add_option("--rig", noise.rig, "Cameras' calibration (replaces the input's own)");
    command->add_option("--frames", noise.frames, "How many are measured (default: 60)")
        ->check(CLI::Range(std::uint64_t{3}, std::uint64_t{1000}));
    command->add_flag("--json", noise.json, "Figures for machines");
    command->add_option("--output", noise.output, "Configuration file, .toml")->required();
    command->footer(
        "Example: autostereo calibrate noise --input recording.mkv --output noise.toml");
}

void addDisplay(CLI::App& calibrate, CalibrateDisplayOptions& display) {
    CLI::App* command = calibrate.add_subcommand(
        "display",
        "A display's own pitch, slant, offset and fan, from photographs of patterns or by eye");
    command->add_option("--display", display.display, "Its model's name, or a file to start from")
        ->required();
    command->add_option("--camera", display.camera,
                        "Rig file whose colour camera took them (calibrate cameras)");
    command->add_option("--photographs", display.photographs,
                        "From each of two places or more, side by side: pattern calibration-board, "
                        "then calibration-fringes-1, -2, -3, the camera on a tripod (PNG, JPEG)");
    command->add_flag("--keys", display.keys,
                      "Or by eye: full screen on the panel itself, arrow keys change the numbers");
    command->add_flag("--json", display.json, "Figures for machines");
    command->add_option("--output", display.output, "Display file, .toml (an old one kept as .old)")
        ->required();
    command->footer("Example: autostereo calibrate display --display looking-glass-portrait "
                    "--camera camera.toml --photographs left-*.jpg right-*.jpg --output mine.toml");
}

void addBoard(CLI::App& command, BoardOptions& options) {
    command.add_option("--depth", options.depth,
                       "Pictures of the board by the depth camera (infrared or amplitude, PNG)");
    command.add_option("--color", options.color,
                       "By the colour camera (PNG, JPEG), in the same order");
    command.add_option("--input", options.input, "Or an input URI in which the board moves");
    command.add_option("--views", options.views, "Of an input: pairs that are taken")
        ->capture_default_str()
        ->check(CLI::Range(std::uint64_t{5}, std::uint64_t{200}));
    command.add_option("--every", options.every, "Of an input: every so manieth")
        ->capture_default_str()
        ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{100000}));
    command.add_flag("--live", options.live,
                     "Of an input: say what to do and take what is still, sharp and new");
    command.add_option("--board", options.board, "Inner corners, COLUMNSxROWS (default: 9x6)");
    command.add_option("--square-mm", options.squareMm, "Side of a square, mm (default: 25)")
        ->check(CLI::Range(0.1, 10000.0));
    command.add_option("--dictionary", options.dictionary,
                       "ChArUco board with markers of this dictionary, e.g. 4x4_50");
    command.add_option("--marker-mm", options.markerMm, "Side of its markers, mm");
    command.add_option("--opencv", options.opencv, "The numbers as OpenCV's YAML, too");
    command.add_flag("--json", options.json, "Figures for machines");
    command.add_option("--output", options.output, "Rig file, .toml (an old one is kept as .old)")
        ->required();
}

} // namespace

void addCalibrate(CLI::App& app, CalibrateNoiseOptions& noise, CalibrateCamerasOptions& cameras,
                  CalibrateRigOptions& rig, CalibrateTimingOptions& timing,
                  CalibrateDisplayOptions& display) {
    CLI::App* calibrate = app.add_subcommand("calibrate", "Measure cameras and displays");
    calibrate->require_subcommand(1);
    addNoise(*calibrate, noise);
    addDisplay(*calibrate, display);
    CLI::App* command = calibrate->add_subcommand(
        "cameras", "Each camera's lens, from pictures of a chessboard or ChArUco board");
    addBoard(*command, cameras);
    command->footer("Example: autostereo calibrate cameras --color board*.jpg --board 9x6 "
                    "--square-mm 25 --output camera.toml");
    command = calibrate->add_subcommand(
        "rig", "Both cameras and how they stand to each other, from the board or listed points");
    addBoard(*command, rig);
    command->add_option("--pairs", rig.pairs,
                        "Or a list of points: depth x y, depth in mm, colour x y (needs --rig)");
    command->add_option("--rig", rig.rig,
                        "The cameras' own numbers, which stay: with --pairs or --input only the "
                        "transform is found, from the depth camera's own points");
    command->footer("Example: autostereo calibrate rig --depth ir*.png --color color*.jpg --board "
                    "9x6 --square-mm 25 --output rig.toml");
    timing.views = 90;
    timing.every = 1;
    command = calibrate->add_subcommand(
        "timing", "How late the colour camera's stamps are, from a board that is waved about");
    addBoard(*command, timing);
    command->add_option("--rig", timing.rig, "Both cameras' calibration, to which it is added")
        ->required();
    command->footer("Example: autostereo calibrate timing --input live.mkv --rig rig.toml --board "
                    "9x6 --square-mm 25 --output rig.toml");
}
} // namespace autostereo::daemon
