#include "gpu/views/layer_search.hpp"

#include "gpu/gl/dispatch.hpp"

namespace autostereo::gpu {

LayerSearch::LayerSearch() : corners_({"quad_corners.comp"}), blocks_({"search_blocks.comp"}) {}

void LayerSearch::build(const CyclopeanScene& scene) {
    const int columns = scene.depth.width(), rows = scene.depth.height();
    if (!quads_.isSized(columns, 2 * rows)) resize(columns, rows);
    glBindTextureUnit(0, scene.depth.name());
    glBindTextureUnit(1, scene.backgroundDepth.name());
    glBindImageTexture(0, quads_.name(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
    glBindImageTexture(1, changed_.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R8UI);
    gl::dispatch(corners_, columns, rows);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    glBindTextureUnit(0, quads_.name());
    glBindImageTexture(0, tops_.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R32F);
    gl::dispatch(blocks_, tops_.width(), tops_.height());
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

void LayerSearch::forgetChanges() { markBlocks(0); }

void LayerSearch::bind() const {
    glBindTextureUnit(0, quads_.name());
    glBindTextureUnit(7, tops_.name());
}

void LayerSearch::resize(int columns, int rows) {
    quads_ = gl::Texture(GL_RGBA32F, columns, 2 * rows);
    const int blocks = (columns + kBlock - 1) / kBlock;
    tops_ = gl::Texture(GL_R32F, blocks, 2 * rows);
    changed_ = gl::Texture(GL_R8UI, blocks, 2 * rows);
    markBlocks(1); // there was nothing before
}

void LayerSearch::markBlocks(std::uint8_t mark) const {
    glClearTexImage(changed_.name(), 0, GL_RED_INTEGER, GL_UNSIGNED_BYTE, &mark);
}

} // namespace autostereo::gpu
