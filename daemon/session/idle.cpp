#include "daemon/session/idle.hpp"

#include "daemon/session/message_panel.hpp"
#include "gpu/gl/error.hpp"

#include <spdlog/spdlog.h>

#include <stdexcept>

namespace autostereo::daemon {

Idle::Idle(const config::Config& config) { open(config); }

void Idle::open(const config::Config& config) {
    file_ = config.idle.content;
    content_.reset();
    try {
        content_ = openIdleContent(config);
    } catch (const std::runtime_error& error) {
        spdlog::warn("idle: {}", error.what());
    }
}

void Idle::replace(const config::Config& config) {
    if (config.idle.content != file_)
        open(config);
    else if (content_)
        content_->replace(config);
}

void Idle::draw(const std::string& text, double seconds, const StandingTarget& target) {
    if (content_ && text.empty()) return drawContent(seconds, target);
    drawMessage(content_ ? content_->background() : calib::Picture{}, text, target);
}

void Idle::drawContent(double seconds, const StandingTarget& target) {
    try {
        return content_->draw(seconds, target);
    } catch (const gpu::PanelLost&) {
        throw;
    } catch (const std::runtime_error& error) {
        spdlog::warn("idle: {}", error.what());
        content_.reset();
    }
    drawMessage({}, "", target);
}

} // namespace autostereo::daemon
