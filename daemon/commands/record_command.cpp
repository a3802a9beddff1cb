#include "daemon/commands/commands.hpp"
#include "daemon/log.hpp"
#include "daemon/stop_signal.hpp"
#include "daemon/wiring.hpp"

#include <spdlog/spdlog.h>

namespace autostereo::daemon {

int record(const RecordOptions& options) {
    constexpr std::chrono::milliseconds kFrameWait{100};
    const config::Config config = configuration(options.scene);
    setUpLog(config.log.level);
    const StopSignal stop;
    const config::Speed speed = options.speed.value_or(config::Speed::Realtime);
    Recording recording(options.output, options.recordRaw, speed, {});
    devices::SteadyClock clock;
    auto feed = openFeed(openScene(config, recording.tap(config)), config, speed, false, clock);
    const auto isOver = [&] {
        const auto pairs = feed->counters().pairs;
        return feed->ended() || (options.frames && pairs >= *options.frames) ||
               !recording.counters()->error.empty();
    };
    while (!stop.requested() && !isOver())
        static_cast<void>(feed->next(kFrameWait));
    feed.reset();
    recording.finish();
    const auto counters = recording.counters();
    if (!counters->error.empty()) throw devices::RecordingError(counters->error);
    if (counters->written == 0)
        throw devices::DeviceError("record: " + config.input + " gave no picture");
    if (const std::string error = recording.rawError(); !error.empty())
        throw devices::RecordingError(error); // the other one is complete
    return EXIT_SUCCESS;
}

} // namespace autostereo::daemon
