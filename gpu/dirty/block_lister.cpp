#include "gpu/dirty/block_lister.hpp"

namespace autostereo::gpu {

BlockLister::BlockLister() : program_({"list_blocks.comp"}) {}

void BlockLister::list(BlockList& list, std::initializer_list<Source> sources,
                       const BlockMarks* among) {
    constexpr int kPerGroup = 64;
    ListBlock block;
    std::size_t next = 0;
    for (const Source& source : sources) {
        glBindTextureUnit(static_cast<GLuint>(next), source.marks.texture().name());
        block.reach.at(next++) = {BlockMarks::blocksOf(source.reachX),
                                  BlockMarks::blocksOf(source.reachY), source.cross ? 1 : 0,
                                  static_cast<int>(source.size)};
    }
    block.size = {list.across(), list.down(), among != nullptr ? 1 : 0, 0};
    if (among != nullptr) glBindTextureUnit(kMostSources, among->texture().name());
    uniforms_.bind(7, block);
    list.beginFinding();
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    program_.use();
    glDispatchCompute(
        static_cast<GLuint>((list.across() * list.down() + kPerGroup - 1) / kPerGroup), 1, 1);
}

} // namespace autostereo::gpu
