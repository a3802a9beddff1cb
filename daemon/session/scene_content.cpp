#include "daemon/session/scene_content.hpp"

#include "devices/mesh/open_mesh.hpp"
#include "devices/uri.hpp"

#include <spdlog/spdlog.h>

namespace autostereo::daemon {

bool isScene(const config::Config& config) {
    const devices::Uri uri = devices::parseUri(config.input);
    return uri.scheme.empty() && devices::mesh::isMeshFile(uri.path);
}

devices::mesh::MeshScene openMeshScene(const config::Config& config) {
    devices::mesh::MeshScene scene = devices::mesh::openMesh(devices::parseUri(config.input).path);
    for (const std::string& repair : scene.repairs.why)
        spdlog::warn("{}: {}", config.input, repair);
    spdlog::info("input: {}", devices::mesh::describe(scene));
    return scene;
}

gpu::SceneParams sceneParams(const config::Config& config) {
    gpu::SceneParams params = config.scene;
    params.depthScale = config.flat ? 0 : config.pipeline.budget.depthScale.value_or(1);
    return params;
}

} // namespace autostereo::daemon
