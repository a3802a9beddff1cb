#include "gpu/registered_depth.hpp"

#include "gpu/gl/dispatch.hpp"

namespace autostereo::gpu {

namespace {

/// Keys are drawn over, cleared and read.
constexpr GLbitfield kDrawn = GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT |
                              GL_TEXTURE_FETCH_BARRIER_BIT;

} // namespace

RegisteredDepth::RegisteredDepth()
    : resolve_({"full_screen.vert", "register_metres.frag"}), vertexArray_(gl::makeVertexArray()) {}

void RegisteredDepth::clear(int width, int height) {
    if (!metres_.isSized(width, height)) {
        metres_ = gl::Texture(GL_R32F, width, height);
        framebuffer_ = gl::makeFramebuffer(metres_);
        keys_ = gl::Texture(GL_R32UI, width, height);
    }
    glClearTexImage(keys_.name(), 0, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
}

void RegisteredDepth::use(const gl::Program& pass, Grid grid) const {
    pass.use();
    for (GLuint unit = 0; unit < grid.size(); ++unit)
        glBindTextureUnit(unit, grid[unit]->name());
    glBindImageTexture(0, keys_.name(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32UI);
}

void RegisteredDepth::drawMesh(const gl::Program& pass, Grid grid) {
    use(pass, grid);
    gl::dispatch(pass, grid[0]->width() - 1, grid[0]->height() - 1);
    glMemoryBarrier(kDrawn);
}

void RegisteredDepth::drawCuts(const gl::Program& pass, Grid grid, const gl::Buffer& cuts) {
    use(pass, grid);
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, cuts.name());
    glDispatchComputeIndirect(0);
    glMemoryBarrier(kDrawn);
}

void RegisteredDepth::resolve() {
    resolve_.use();
    glBindTextureUnit(0, keys_.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_.name());
    glViewport(0, 0, metres_.width(), metres_.height());
    glBindVertexArray(vertexArray_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

} // namespace autostereo::gpu
