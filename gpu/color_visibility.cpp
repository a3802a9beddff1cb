#include "gpu/color_visibility.hpp"

#include "gpu/gl/dispatch.hpp"

namespace autostereo::gpu {

ColorVisibility::ColorVisibility(const DepthMeshParams& params)
    : drawer_(params), register_({"mesh_register.vert", "mesh_register.frag"}),
      hide_({"color_visibility.comp"}) {}

void ColorVisibility::hide(const MeshLayer& scene) {
    const int width = scene.points.width(), height = scene.points.height();
    if (!registered_.isSized(width, height)) {
        registered_ = gl::Texture(GL_R32F, width, height);
        depth_ = gl::Texture(GL_DEPTH_COMPONENT32F, width, height);
        clean_ = gl::Texture(GL_R8UI, width, height);
        framebuffer_ = gl::makeFramebuffer(registered_, &depth_);
    }
    drawer_.clear(framebuffer_.name(), {0, 0, 0});
    glViewport(0, 0, width, height);
    register_.use();
    drawer_.drawScene(scene);

    glBindTextureUnit(0, registered_.name());
    glBindTextureUnit(1, scene.sources.name());
    glBindImageTexture(0, scene.points.name(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
    glBindImageTexture(1, clean_.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R8UI);
    gl::dispatch(hide_, width, height);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

} // namespace autostereo::gpu
