#include "gpu/views/layer_search.hpp"

#include "gpu/gl/dispatch.hpp"

namespace autostereo::gpu {

LayerSearch::LayerSearch() : corners_({"quad_corners.comp"}), blocks_({"search_blocks.comp"}) {}

void LayerSearch::build(const CyclopeanScene& scene) {
    const int columns = scene.depth.width(), rows = scene.depth.height();
    const bool isNew = !quads_.isSized(columns, 2 * rows);
    if (isNew) resize(columns, rows);
    if (isNew || scene.changes == nullptr)
        stale_.listAll();
    else
        lister_.list(stale_, {{scene.changes->depth, 1, 1}}); // corners lie between texels
    glBindTextureUnit(0, scene.depth.name());
    glBindTextureUnit(1, scene.backgroundDepth.name());
    glBindImageTexture(0, quads_.name(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
    glBindImageTexture(1, changed_.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R8UI);
    changedBlocks_.bind(2);
    stale_.dispatch(corners_);
    glBindTextureUnit(0, quads_.name());
    glBindImageTexture(0, tops_.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R32F);
    stale_.dispatch(blocks_);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

void LayerSearch::forgetChanges() const {
    glClearTexImage(changed_.name(), 0, GL_RED_INTEGER, GL_UNSIGNED_BYTE, nullptr);
    changedBlocks_.clear();
}

void LayerSearch::bind() const {
    glBindTextureUnit(0, quads_.name());
    glBindTextureUnit(7, tops_.name());
}

void LayerSearch::resize(int columns, int rows) {
    quads_ = gl::Texture(GL_RGBA32F, columns, 2 * rows);
    const int blocks = (columns + kBlock - 1) / kBlock;
    tops_ = gl::Texture(GL_R32F, blocks, 2 * rows);
    changed_ = gl::Texture(GL_R8UI, blocks, 2 * rows);
    stale_.resize(columns, rows);
    changedBlocks_.resize(columns, rows);
    markAll(); // there was nothing before
}

void LayerSearch::markAll() const {
    const std::uint8_t mark = 1;
    glClearTexImage(changed_.name(), 0, GL_RED_INTEGER, GL_UNSIGNED_BYTE, &mark);
    changedBlocks_.markAll();
}

} // namespace autostereo::gpu
