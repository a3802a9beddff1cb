#include "daemon/commands/render_scene.hpp"

#include "daemon/commands/view_files.hpp"
#include "daemon/picture_files.hpp"
#include "daemon/session/scene_content.hpp"
#include "daemon/wiring.hpp"
#include "gpu/offscreen_panel.hpp"
#include "gpu/scene/scene_pipeline.hpp"

namespace autostereo::daemon {

namespace {

void checkScene(const RenderOptions& options, Picture as, const gpu::SceneParams& look) {
    if (as == Picture::Depth || as == Picture::Disparity || options.cameraOffset)
        throw UsageError("render: a scene has no cameras: --as depth, --as disparity and "
                         "--camera-offset need some");
    if (options.reference)
        throw UsageError("render: --reference searches cameras' pictures; a scene has none");
    const bool isDeferred =
        options.method == gpu::Method::Direct || options.method == gpu::Method::Hybrid;
    if (isDeferred && look.shading == gpu::SceneShading::PerVertex)
        throw UsageError("render: --method " + std::string(gpu::methodName(*options.method)) +
                         " lights what views show, but scene.shading is per-vertex: name another "
                         "one (allowed: instanced, multipass, geometry, mrt)");
}

} // namespace

int renderScene(const RenderOptions& options, Picture as, const config::Config& config,
                const calib::DisplayProfile& display) {
    const gpu::SceneParams look = sceneParams(config);
    checkScene(options, as, look);
    const devices::mesh::MeshScene scene = openMeshScene(config.input);
    const PanelSize size = offscreenSize(display);
    gpu::OffscreenPanel panel(size.width, size.height, false);
    gpu::ScenePipeline pipeline(scene, look, config.pipeline, display, size.width, size.height);
    pipeline.prepare(static_cast<double>(options.frame) / kSceneRate);
    switch (as) {
    case Picture::Quilt:
        writePicturePng(options.output, readAtlas(pipeline.atlas()));
        break;
    case Picture::Views:
        writeViews(pipeline.atlas(), options.output);
        break;
    case Picture::View:
        writePicturePng(
            options.output,
            pipeline.renderEye(options.eye.value_or(glm::dvec3{0, 0, display.viewingDistanceM}),
                               size.width, size.height));
        break;
    default:
        pipeline.show(panel.framebuffer());
        writePicturePng(options.output,
                        gpu::readFramebuffer(panel.framebuffer(), size.width, size.height));
    }
    return EXIT_SUCCESS;
}

} // namespace autostereo::daemon
