#include "daemon/session/scene_content.hpp"

#include "devices/mesh/open_mesh.hpp"
#include "devices/uri.hpp"

#include <spdlog/spdlog.h>

namespace autostereo::daemon {

bool isScene(const config::Config& config) {
    const devices::Uri uri = devices::parseUri(config.input);
    return uri.scheme.empty() && devices::mesh::isMeshFile(uri.path);
}

devices::mesh::MeshScene openMeshScene(const std::string& file) {
    devices::mesh::MeshScene scene = devices::mesh::openMesh(devices::parseUri(file).path);
    for (const std::string& repair : scene.repairs.why)
        spdlog::warn("{}: {}", file, repair);
    spdlog::info("scene: {}", devices::mesh::describe(scene));
    return scene;
}

bool sceneMoves(const config::Config& config, const devices::mesh::MeshScene& scene) {
    return config.scene.turnS != 0 || scene.periodS > 0;
}

gpu::SceneParams sceneParams(const config::Config& config) {
    gpu::SceneParams params = config.scene;
    params.depthScale = config.flat ? 0 : config.pipeline.budget.depthScale.value_or(1);
    return params;
}

} // namespace autostereo::daemon
