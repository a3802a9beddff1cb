#include "config/rig_file.hpp"
#include "daemon/commands/commands.hpp"
#include "daemon/log.hpp"
#include "daemon/session/idle_content.hpp"
#include "daemon/wiring.hpp"
#include "devices/mesh/open_mesh.hpp"
#include "devices/replay_feed.hpp"
#include "devices/single_stream.hpp"

#include <iostream>

namespace autostereo::daemon {

namespace {

/// A rig, whole or in part, with what its calibration says of itself.
std::string rigText(const std::filesystem::path& file) {
    if (file.extension() == ".json") {
        static_cast<void>(config::loadRig(file));
        return "rig";
    }
    const config::RigFile rig = config::readRigFile(file);
    std::string what = rig.depth && rig.color && rig.colorFromDepth ? "rig" : "part of a rig";
    if (rig.quality.empty()) return what;
    for (const std::string& line : config::explained(rig))
        what += "\n  " + line;
    return what;
}

/// A configuration is not good where it names content that cannot be shown.
void inspectConfig(const std::filesystem::path& file) {
    const config::Config config = config::loadConfig(file);
    try {
        static_cast<void>(openIdleContent(config));
    } catch (const std::runtime_error& error) {
        throw config::ConfigError(file.string() + ": idle.content: " + error.what());
    }
}

/// What the file is, in a few words. Throws what its reader throws.
std::string inspectText(const std::filesystem::path& file) {
    switch (config::kindOf(file)) {
    case config::FileKind::Config:
        inspectConfig(file);
        return "configuration";
    case config::FileKind::Display:
        return "display, " + config::loadDisplay(file.string()).model;
    case config::FileKind::Rig:
        return rigText(file);
    }
    return "";
}

/// Plays a recording to its end.
std::string inspectRecording(const std::string& uri) {
    devices::Input input = devices::openInput(uri);
    std::string what = input.description;
    if (!input.rig) input.rig = config::exampleRig();
    devices::ReplayFeed feed(devices::completeStreams(std::move(input)), {}, false);
    while (!feed.ended())
        static_cast<void>(feed.next(std::chrono::milliseconds(0)));
    const devices::FeedCounters counters = feed.counters();
    const std::uint64_t damaged = counters.depth.damaged + counters.color.damaged;
    what += ", " + std::to_string(counters.pairs) + " pairs, " + std::to_string(damaged) +
            " frames damaged";
    if (counters.pairs == 0 || damaged > 0) throw devices::DeviceError(uri + ": " + what);
    return what;
}

/// A scene that needs repairs is shown, but is not good.
std::string inspectScene(const std::filesystem::path& file) {
    const devices::mesh::MeshScene scene = devices::mesh::openMesh(file);
    std::string what = devices::mesh::describe(scene);
    for (const std::string& repair : scene.repairs.why)
        what += "; " + repair;
    if (!scene.repairs.why.empty()) throw devices::DeviceError(file.string() + ": " + what);
    return what;
}

} // namespace

int check(const CheckOptions& options) {
    constexpr int kBad = 2;
    int code = EXIT_SUCCESS;
    setUpLog("warn");
    for (const std::filesystem::path& file : options.files) {
        try {
            const std::string extension = file.extension().string();
            const bool isText = extension == ".toml" || extension == ".json";
            const std::string what = devices::mesh::isMeshFile(file) ? inspectScene(file)
                                     : isText                        ? inspectText(file)
                                              : inspectRecording(file.string());
            std::cout << file.string() << ": good (" << what << ")\n";
        } catch (const std::exception& error) {
            std::cerr << error.what() << '\n';
            code = kBad;
        }
    }
    return code;
}

} // namespace autostereo::daemon
