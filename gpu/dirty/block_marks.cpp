#include "gpu/dirty/block_marks.hpp"

#include <cstdint>

namespace autostereo::gpu {

void BlockMarks::resize(int columns, int rows) {
    marks_ = gl::Texture(GL_R8UI, blocksOf(columns), blocksOf(rows));
    clear();
}

void BlockMarks::clear() const {
    glClearTexImage(marks_.name(), 0, GL_RED_INTEGER, GL_UNSIGNED_BYTE, nullptr);
}

void BlockMarks::markAll() const {
    const std::uint8_t mark = 1;
    glClearTexImage(marks_.name(), 0, GL_RED_INTEGER, GL_UNSIGNED_BYTE, &mark);
}

void BlockMarks::bind(GLuint imageUnit) const {
    glBindImageTexture(imageUnit, marks_.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R8UI);
}

} // namespace autostereo::gpu
