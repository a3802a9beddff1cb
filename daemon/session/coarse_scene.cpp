#include "daemon/session/coarse_scene.hpp"

namespace autostereo::daemon {

void CoarseScene::Copy::take(const gpu::gl::Texture& from, GLenum format, int width, int height) {
    if (!texture.isSized(width, height)) {
        texture = gpu::gl::Texture(format, width, height);
        frame = gpu::gl::makeFramebuffer(texture);
    }
    const gpu::gl::Framebuffer source = gpu::gl::makeFramebuffer(from);
    glBlitNamedFramebuffer(source.name(), frame.name(), 0, 0, from.width(), from.height(), 0, 0,
                           width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

gpu::CyclopeanScene CoarseScene::of(const gpu::CyclopeanScene& scene) {
    int step = 1;
    const auto texels = [&] {
        return (scene.depth.width() / step) * (scene.depth.height() / step);
    };
    while (texels() > mostTexels_)
        ++step;
    const int width = scene.depth.width() / step, height = scene.depth.height() / step;
    depth_.take(scene.depth, GL_R32F, width, height);
    backgroundDepth_.take(scene.backgroundDepth, GL_R32F, width, height);
    backgroundColor_.take(scene.backgroundColor, GL_RGBA8, width, height);
    return {depth_.texture, scene.color, backgroundDepth_.texture, backgroundColor_.texture};
}

} // namespace autostereo::daemon
