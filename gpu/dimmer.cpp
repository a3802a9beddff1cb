#include "gpu/dimmer.hpp"

namespace autostereo::gpu {

Dimmer::Dimmer()
    : program_({"full_screen.vert", "dim.frag"}), vertexArray_(gl::makeVertexArray()) {}

void Dimmer::dim(GLuint framebuffer, const Area& area, double brightness) {
    const auto level = static_cast<float>(brightness);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    glViewport(area.x, area.y, area.width, area.height);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_ZERO, GL_CONSTANT_COLOR, GL_ZERO, GL_ONE);
    glBlendColor(level, level, level, 1);
    program_.use();
    glBindVertexArray(vertexArray_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_BLEND);
}

} // namespace autostereo::gpu
