#include "gpu/views/layer_search.hpp"

#include "gpu/gl/dispatch.hpp"

namespace autostereo::gpu {

LayerSearch::LayerSearch() : corners_({"quad_corners.comp"}), blocks_({"search_blocks.comp"}) {}

void LayerSearch::build(const CyclopeanScene& scene) {
    const int columns = scene.depth.width(), rows = scene.depth.height();
    if (!quads_.isSized(columns, 2 * rows)) resize(columns, rows);
    glBindTextureUnit(0, scene.depth.name());
    glBindTextureUnit(1, scene.backgroundDepth.name());
    glBindImageTexture(0, quads_.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
    gl::dispatch(corners_, columns, rows);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    glBindTextureUnit(0, quads_.name());
    glBindImageTexture(0, tops_.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R32F);
    gl::dispatch(blocks_, tops_.width(), tops_.height());
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

void LayerSearch::bind() const {
    glBindTextureUnit(0, quads_.name());
    glBindTextureUnit(7, tops_.name());
}

void LayerSearch::resize(int columns, int rows) {
    quads_ = gl::Texture(GL_RGBA32F, columns, 2 * rows);
    tops_ = gl::Texture(GL_R32F, (columns + kBlock - 1) / kBlock, 2 * rows);
}

} // namespace autostereo::gpu
