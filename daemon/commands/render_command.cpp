#include "daemon/commands/commands.hpp"
#include "daemon/commands/plain_display.hpp"
#include "daemon/commands/render_scene.hpp"
#include "daemon/commands/view_files.hpp"
#include "daemon/log.hpp"
#include "daemon/picture_files.hpp"
#include "daemon/session/scene_content.hpp"
#include "daemon/wiring.hpp"
#include "devices/replay_feed.hpp"
#include "gpu/exports.hpp"
#include "gpu/offscreen_panel.hpp"
#include "tests/bench/views/reference.hpp"

namespace autostereo::daemon {

namespace {

/// Pair number `wanted` of an input. Throws DeviceError where it has fewer.
devices::RgbdFrame frameAt(devices::Feed& feed, std::uint64_t wanted, const std::string& input) {
    std::uint64_t seen = 0;
    while (!feed.ended()) {
        auto frame = feed.next(std::chrono::milliseconds(0));
        if (frame && seen++ == wanted) return std::move(*frame);
    }
    throw devices::DeviceError(
        "render: cannot show frame " + std::to_string(wanted) + " of " + input + ": it has " +
        std::to_string(seen) + " (from 0; " +
        std::to_string(feed.counters().depth.damaged + feed.counters().color.damaged) +
        " frames damaged)");
}

/// The display, or the format that stands in for it.
calib::DisplayProfile displayAs(Picture as, const calib::DisplayProfile& display) {
    const PanelSize size = offscreenSize(display);
    const auto plain = [&](PlainFormat format) {
        return plainDisplay(display, format, size.width, size.height);
    };
    if (as == Picture::DepthFrame) return plain(PlainFormat::DepthFrame);
    if (as == Picture::SideBySide) return plain(PlainFormat::SideBySide);
    if (as == Picture::Anaglyph) return plain(PlainFormat::Anaglyph);
    return display;
}

/// Quilts and views need a method that draws views.
void chooseTiles(const RenderOptions& options, Picture as, gpu::Method& method) {
    const bool wantsTiles = as == Picture::Quilt || as == Picture::Views;
    if (wantsTiles && (method == gpu::Method::Direct || method == gpu::Method::Auto)) {
        if (options.method == gpu::Method::Direct)
            throw UsageError(
                "render: --method direct draws no views: for --as quilt and --as "
                "views name another one (allowed: instanced, multipass, geometry, mrt, hybrid)");
        method = gpu::Method::Instanced;
    }
}

} // namespace

int render(const RenderOptions& options) {
    config::Config config = configuration(options.scene);
    setUpLog(config.log.level);
    if (options.method) config.pipeline.synthesis.method = *options.method;
    const Picture as = options.as.value_or(Picture::Panel);
    chooseTiles(options, as, config.pipeline.synthesis.method);
    const calib::DisplayProfile display = displayAs(as, chooseDisplay(config));
    if (isScene(config)) return renderScene(options, as, config, display);
    devices::Input input = openScene(config);
    const calib::SensorRig rig = *input.rig;
    devices::ReplayFeed feed(std::move(input), config.sync, false);
    const devices::RgbdFrame frame = frameAt(feed, options.frame, config.input);

    const PanelSize size = offscreenSize(display);
    gpu::OffscreenPanel panel(size.width, size.height, false);
    const gpu::PipelineParams params = pipelineParams(config, false);
    gpu::Pipeline pipeline(params, rig, display, size.width, size.height);
    pipeline.render(frame, panel.framebuffer());

    switch (as) {
    case Picture::Panel:
    case Picture::DepthFrame:
    case Picture::SideBySide:
    case Picture::Anaglyph:
        writePicturePng(options.output,
                        options.reference
                            ? bench::referencePanel(pipeline, rig, display, size.width, size.height,
                                                    params.synthesis.positions)
                            : gpu::readFramebuffer(panel.framebuffer(), size.width, size.height));
        break;
    case Picture::Quilt:
        writePicturePng(options.output, readAtlas(*pipeline.atlas()));
        break;
    case Picture::Views:
        writeViews(*pipeline.atlas(), options.output);
        break;
    case Picture::View:
        writePicturePng(
            options.output,
            options.cameraOffset
                ? gpu::MovedCamera(params, rig, *options.cameraOffset).render(pipeline)
                : gpu::renderEye(pipeline, params, display,
                                 options.eye.value_or(glm::dvec3{0, 0, display.viewingDistanceM}),
                                 size.width, size.height));
        break;
    case Picture::Disparity:
        writeFloatTiff(options.output,
                       gpu::renderDisparity(pipeline, params, display, size.width, size.height));
        break;
    case Picture::Depth:
        writeDepthPng(options.output,
                      gpu::renderRegisteredDepth(pipeline.depth(),
                                                 frame.depth.metadata().depthUnitM, params, rig));
        break;
    }
    return EXIT_SUCCESS;
}

} // namespace autostereo::daemon
