#include "daemon/session/idle_content.hpp"

#include "config/load.hpp"
#include "daemon/session/idle_picture.hpp"
#include "daemon/session/idle_quilt.hpp"
#include "daemon/session/idle_recording.hpp"
#include "daemon/session/idle_scene.hpp"
#include "devices/content_kind.hpp"

namespace autostereo::daemon {

const calib::Picture& IdleContent::background() const {
    static const calib::Picture kPlain;
    return kPlain;
}

std::unique_ptr<IdleContent> openIdleContent(const config::Config& config) {
    const std::string& file = config.idle.content;
    if (file.empty()) return nullptr;
    const auto kind = devices::contentKind(file);
    if (!kind)
        throw config::ConfigError("idle.content: " + file + " is of no kind that can be shown");
    switch (*kind) {
    case devices::ContentKind::Picture:
        return std::make_unique<IdlePicture>(file);
    case devices::ContentKind::Quilt:
        return std::make_unique<IdleQuilt>(file);
    case devices::ContentKind::Recording:
        return std::make_unique<IdleRecording>(config);
    case devices::ContentKind::Scene:
        break;
    }
    return std::make_unique<IdleScene>(config);
}

} // namespace autostereo::daemon
