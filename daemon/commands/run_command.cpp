#include "daemon/commands/commands.hpp"
#include "daemon/control/control_desk.hpp"
#include "daemon/log.hpp"
#include "daemon/reload_signal.hpp"
#include "daemon/session/session.hpp"
#include "daemon/stop_signal.hpp"

#include <spdlog/spdlog.h>

namespace autostereo::daemon {

namespace {

constexpr const char* kOffscreenPicture = "autostereo-panel.png";

} // namespace

int run(const RunOptions& options) {
    const config::Config config = configuration(options.scene);
    setUpLog(config.log.level);
    const StopSignal stop; // before the window opens: closing it gives the screen saver back
    Session session(options, config);
    ControlDesk desk(options, config, session);
    const ReloadSignal hangup;
    while (!stop.requested() && session.step()) {
        desk.serve();
        if (hangup.take()) desk.reload();
    }
    const Report& report = session.close();
    spdlog::info("{}", report.summary());
    std::optional<std::filesystem::path> picture = options.snapshot;
    if (!picture && report.presented > 0 && session.offscreen() && !options.frames)
        picture = kOffscreenPicture;
    if (picture && report.presented == 0) {
        spdlog::warn("panel: stopped before the first frame, so there is no picture to write");
    } else if (picture) {
        session.writePicture(*picture);
        spdlog::info("panel: {}", std::filesystem::absolute(*picture).string());
    }
    if (options.report) writeReport(report, *options.report);
    if (session.endedWithoutPicture())
        throw devices::DeviceError(
            "run: cannot show " + config.input + ": it ended without a pair of frames (" +
            std::to_string(report.feed.depth.damaged + report.feed.color.damaged) + " damaged)");
    return EXIT_SUCCESS;
}

} // namespace autostereo::daemon
