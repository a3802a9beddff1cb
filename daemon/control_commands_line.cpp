#include "daemon/command_words.hpp"

namespace autostereo::daemon {

namespace {

CLI::App* addControl(CLI::App& app, ControlOptions& control, const char* name, const char* what,
                     const ControlRequest& request) {
    CLI::App* command = app.add_subcommand(name, what);
    command->add_option("--socket", control.socket, "The program's control socket");
    command->preparse_callback([&control, request](std::size_t) { control.request = request; });
    return command;
}

void addSet(CLI::App& app, ControlOptions& control) {
    CLI::App* command =
        addControl(app, control, "set", "Change a running program's picture at once", SetRequest{});
    command
        ->add_option_function<std::string>(
            "setting",
            [&control](const std::string& words) {
                const std::size_t equals = words.find('=');
                if (equals == std::string::npos || equals == 0)
                    throw UsageError("set: " + words + " is no KEY=VALUE");
                control.request = SetRequest{words.substr(0, equals), words.substr(equals + 1)};
            },
            "KEY=VALUE: scale, focus (m or auto), method, brightness (0 to 1), mode (2d or 3d)")
        ->required();
    command->footer("Example: autostereo set scale=0.7");
}

} // namespace

void addControlCommands(CLI::App& app, ControlOptions& control) {
    CLI::App* status = addControl(app, control, "status", "What a running program shows, and why",
                                  StatusRequest{});
    status->add_flag("--json", control.json, "For machines");
    status->footer("Example: autostereo status --json");

    CLI::App* snapshot =
        addControl(app, control, "snapshot", "The panel of a running program", SnapshotRequest{});
    snapshot->add_option("file", control.output, "PNG, or Matroska with --recording")->required();
    snapshot->add_flag_callback(
        "--recording", [&control] { control.request = RecordingRequest{}; },
        "The cameras' last seconds instead, where [record] ring_s keeps them");
    snapshot->footer("Example: autostereo snapshot panel.png");

    CLI::App* reload = addControl(app, control, "reload",
                                  "A running program reads its configuration again (as by SIGHUP)",
                                  ReloadRequest{});
    reload->footer("Example: autostereo reload --socket /run/autostereo/control.sock");

    addSet(app, control);

    CLI::App* show = addControl(app, control, "show", "A test pattern on a running program's panel",
                                ShowRequest{});
    show->add_option_function<std::string>(
            "what", [&control](const std::string& what) { control.request = ShowRequest{what}; },
            "numbers, colors, lines, halves, ramps, or live: back to the picture")
        ->required();
    show->footer("Example: autostereo show numbers");
}

} // namespace autostereo::daemon
