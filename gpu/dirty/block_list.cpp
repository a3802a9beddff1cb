#include "gpu/dirty/block_list.hpp"

#include <numeric>

namespace autostereo::gpu {

namespace {
constexpr std::size_t kHeader = 4; // as in shaders/listed_blocks.glsl
}

void BlockList::resize(int columns, int rows) {
    across_ = BlockMarks::blocksOf(columns);
    down_ = BlockMarks::blocksOf(rows);
    const auto blocks = static_cast<std::size_t>(across_) * static_cast<std::size_t>(down_);
    std::vector<GLuint> numbers(kHeader + blocks);
    std::iota(numbers.begin() + kHeader, numbers.end(), 0U);
    numbers[0] = static_cast<GLuint>(blocks);
    numbers[1] = numbers[2] = 1;
    numbers[3] = static_cast<GLuint>(across_);
    const std::size_t bytes = numbers.size() * sizeof(GLuint);
    all_ = gl::makeBuffer(bytes, numbers.data(), 0);
    found_ = gl::makeBuffer(bytes, numbers.data(), GL_DYNAMIC_STORAGE_BIT);
    listAll();
}

void BlockList::dispatch(const gl::Program& program) const {
    const gl::Buffer& list = listsAll_ ? all_ : found_;
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                    GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 6, list.name());
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, list.name());
    program.use();
    glDispatchComputeIndirect(0);
}

void BlockList::drawPoints() const {
    const gl::Buffer& list = listsAll_ ? all_ : found_;
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 6, list.name());
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, list.name());
    glDrawArraysIndirect(GL_POINTS, nullptr);
}

void BlockList::beginFinding() {
    listsAll_ = false;
    const GLuint none = 0;
    glNamedBufferSubData(found_.name(), 0, sizeof none, &none);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 6, found_.name());
}

} // namespace autostereo::gpu
