#pragma once

#include "daemon/session/idle_content.hpp"
#include "devices/mesh/mesh_scene.hpp"
#include "gpu/scene/scene_pipeline.hpp"

#include <optional>

namespace autostereo::daemon {

/// A scene of triangles as [scene] has it. Thread-bound.
class IdleScene final : public IdleContent {
  public:
    explicit IdleScene(const config::Config& config);

    [[nodiscard]] bool moves() const override;
    [[nodiscard]] bool advance(double /*seconds*/) override { return moves(); }
    void draw(double seconds, const StandingTarget& target) override;
    void replace(const config::Config& config) override;
    void leave() override { pipeline_.reset(); }

  private:
    config::Config config_;
    devices::mesh::MeshScene scene_;
    std::optional<gpu::ScenePipeline> pipeline_; ///< none while nobody sees it
};

} // namespace autostereo::daemon
