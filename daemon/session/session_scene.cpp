// A session whose content is a scene of triangles.

#include "daemon/session/scene_content.hpp"
#include "daemon/session/session.hpp"

#include <spdlog/spdlog.h>

namespace autostereo::daemon {

void Session::startScene() {
    if (!config_.viewer.source.empty())
        spdlog::warn("viewer: a scene is drawn for the display's own places, not for {}",
                     config_.viewer.source);
    screen_.start(*scene_);
}

double Session::sceneSeconds() const {
    if (realtime_) return std::chrono::duration<double>(clock_.now() - started_).count();
    return static_cast<double>(report_.presented) / kSceneRate;
}

bool Session::stepScene() {
    if (realtime_) clock_.sleepUntil(presentedAt_ + kPictureInterval);
    const auto resting = rest();
    if (!pattern_) enter(resting.value_or(Shown::Live));
    powerMonitor();
    const bool moves = sceneMoves(config_, *scene_);
    const bool isFirst = report_.presented == 0;
    const bool stands = clock_.now() - presentedAt_ >= kStillInterval;
    ++before_.pairs; // a moment of the scene: presented or skipped
    if (pattern_ || resting || (!moves && !isFirst && !redraw_)) {
        ++report_.skipped[pattern_ ? "pattern" : resting ? shownName(*resting) : "unchanged"];
        if (redraw_ || (realtime_ && stands)) {
            presentAgain();
        } else if (realtime_) {
            watchdog_.pet(); // what is on the panel is the newest there is
            clock_.sleepUntil(clock_.now() + kPictureInterval);
        }
    } else {
        screen_.showScene(sceneSeconds());
        present();
        ++report_.presented;
    }
    screen_.panel().pollEvents();
    log();
    return true;
}

} // namespace autostereo::daemon
