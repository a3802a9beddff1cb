#include "daemon/session/idle_scene.hpp"

#include "daemon/session/scene_content.hpp"

namespace autostereo::daemon {

IdleScene::IdleScene(const config::Config& config)
    : config_(config), scene_(openMeshScene(config.idle.content)) {}

bool IdleScene::moves() const { return sceneMoves(config_, scene_); }

void IdleScene::replace(const config::Config& config) {
    pipeline_.reset();
    config_ = config;
}

void IdleScene::draw(double seconds, const StandingTarget& target) {
    if (!pipeline_)
        pipeline_.emplace(scene_, sceneParams(config_), config_.pipeline, target.display,
                          target.width, target.height);
    pipeline_->prepare(seconds);
    pipeline_->show(target.framebuffer);
}

} // namespace autostereo::daemon
