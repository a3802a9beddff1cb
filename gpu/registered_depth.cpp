#include "gpu/registered_depth.hpp"

#include "gpu/gl/dispatch.hpp"

namespace autostereo::gpu {

RegisteredDepth::RegisteredDepth() : resolve_({"register_metres.comp"}) {}

void RegisteredDepth::clear(int width, int height) {
    if (!metres_.isSized(width, height)) {
        metres_ = gl::Texture(GL_R32F, width, height);
        keys_ = gl::Texture(GL_R32UI, width, height);
    }
    glClearTexImage(keys_.name(), 0, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
}

void RegisteredDepth::use(const gl::Program& pass, const Grid& grid) const {
    pass.use();
    glBindTextureUnit(0, grid.nodes.points.name());
    glBindTextureUnit(1, grid.nodes.sources.name());
    glBindTextureUnit(2, grid.counts.name());
    if (grid.rays != nullptr) glBindTextureUnit(3, grid.rays->name());
    glBindImageTexture(0, keys_.name(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32UI);
}

void RegisteredDepth::drawMesh(const gl::Program& pass, const Grid& grid) {
    use(pass, grid);
    gl::dispatch(pass, grid.counts.width() - 1, grid.counts.height() - 1);
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

void RegisteredDepth::drawCuts(const gl::Program& pass, const Grid& grid, const gl::Buffer& cuts) {
    use(pass, grid);
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, cuts.name());
    glDispatchComputeIndirect(0);
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

void RegisteredDepth::resolve() {
    glBindImageTexture(0, keys_.name(), 0, GL_FALSE, 0, GL_READ_ONLY, GL_R32UI);
    glBindImageTexture(1, metres_.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R32F);
    gl::dispatch(resolve_, metres_.width(), metres_.height());
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
}

} // namespace autostereo::gpu
