#include "gpu/views/layer_search.hpp"

#include "gpu/gl/dispatch.hpp"

#include <string>

namespace autostereo::gpu {

namespace {

std::string parts(int count) { return "PARTS " + std::to_string(count); }

void reduce(const gl::Program& program, const gl::Texture& fine, const gl::Texture& coarse) {
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    glBindTextureUnit(0, fine.name());
    glBindImageTexture(0, coarse.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R32F);
    gl::dispatch(program, coarse.width(), coarse.height());
}

} // namespace

LayerSearch::LayerSearch()
    : corners_({"quad_corners.comp"}), blocks_({"search_blocks.comp"}, {"QUADS", parts(kBlock)}),
      bigBlocks_({"search_blocks.comp"}, {parts(kBigBlock / kBlock)}) {}

void LayerSearch::build(const CyclopeanScene& scene) {
    const int columns = scene.depth.width(), rows = scene.depth.height();
    if (!quads_.isSized(columns, 2 * rows)) resize(columns, rows);
    glBindTextureUnit(0, scene.depth.name());
    glBindTextureUnit(1, scene.backgroundDepth.name());
    glBindImageTexture(0, quads_.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
    gl::dispatch(corners_, columns, rows);
    reduce(blocks_, quads_, tops_);
    reduce(bigBlocks_, tops_, bigTops_);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

void LayerSearch::bind() const {
    glBindTextureUnit(0, quads_.name());
    glBindTextureUnit(7, tops_.name());
    glBindTextureUnit(8, bigTops_.name());
}

void LayerSearch::resize(int columns, int rows) {
    const auto blocks = [&](int size) { return (columns + size - 1) / size; };
    quads_ = gl::Texture(GL_RGBA32F, columns, 2 * rows);
    tops_ = gl::Texture(GL_R32F, blocks(kBlock), 2 * rows);
    bigTops_ = gl::Texture(GL_R32F, blocks(kBigBlock), 2 * rows);
}

} // namespace autostereo::gpu
