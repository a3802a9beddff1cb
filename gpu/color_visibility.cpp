#include "gpu/color_visibility.hpp"

#include "gpu/gl/dispatch.hpp"

#include <array>

namespace autostereo::gpu {

ColorVisibility::ColorVisibility()
    : drawMesh_({"register_mesh.comp"}), hide_({"color_visibility.comp"}) {}

void ColorVisibility::hide(const MeshLayer& scene, const gl::Texture& counts) {
    const int width = scene.points.width(), height = scene.points.height();
    if (!clean_.isSized(width, height)) clean_ = gl::Texture(GL_R8UI, width, height);
    registered_.clear(width, height);
    const std::array<const gl::Texture*, 3> grid{&scene.points, &scene.sources, &counts};
    registered_.drawMesh(drawMesh_, grid);
    registered_.resolve();

    glBindTextureUnit(0, registered_.metres().name());
    glBindTextureUnit(1, scene.sources.name());
    glBindImageTexture(0, scene.points.name(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
    glBindImageTexture(1, clean_.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R8UI);
    gl::dispatch(hide_, width, height);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

} // namespace autostereo::gpu
