#include "gpu/scene/scene_reprojection.hpp"

#include "gpu/scene/scene_views.hpp"
#include "gpu/views/view_synthesis.hpp"

namespace autostereo::gpu {

SceneReprojection::SceneReprojection(const calib::DisplayProfile& display, SceneShading shading)
    : find_({"full_screen.vert", "scene_reproject.frag"}),
      resolve_({"full_screen.vert", "scene_resolve.frag"}, definesOf(shading)),
      positions_(makeViewPositions(display)), vertexArray_(gl::makeVertexArray()) {}

void SceneReprojection::render(SceneSurfaces& surfaces, const SceneModel& model,
                               const SceneBlock& block, const Atlas& atlas) {
    const AtlasLayout& layout = atlas.layout();
    if (!roots_.isSized(layout.width(), layout.height())) {
        roots_ = gl::Texture(GL_R32UI, layout.width(), layout.height());
        framebuffer_ = gl::makeFramebuffer(roots_, &atlas.depth());
    }
    SceneBlock own = block;
    own.viewTiles = {layout.quilt.columns, layout.quilt.rows, 0, layout.views};
    uniforms_.bind(7, own);
    surfaces.bind();
    glBindTextureUnit(1, model.parts().name());
    glBindTextureUnit(10, positions_.name());
    glBindVertexArray(vertexArray_.name());
    glViewport(0, 0, layout.width(), layout.height());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_.name());
    const DepthTest depthTest;
    find_.use();
    glDepthFunc(GL_ALWAYS);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    const glm::vec4& backdrop = surfaces.block().backdrop;
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, atlas.framebuffer());
    glClearNamedFramebufferfv(atlas.framebuffer(), GL_COLOR, 0, &backdrop.r);
    glBindTextureUnit(2, roots_.name());
    // What shows nothing is not even begun.
    resolve_.use();
    glDepthFunc(GL_LESS);
    glDepthMask(GL_FALSE);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDepthMask(GL_TRUE);
}

} // namespace autostereo::gpu
