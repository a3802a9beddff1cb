#include "gpu/fusion/picture_marks.hpp"

namespace autostereo::gpu {

namespace {

void dispatch(const gl::Program& program, const gl::Texture& blocks) {
    program.use();
    glDispatchCompute(static_cast<GLuint>(BlockMarks::blocksOf(blocks.width())),
                      static_cast<GLuint>(BlockMarks::blocksOf(blocks.height())), 1);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

} // namespace

PictureMarks::PictureMarks()
    : bounds_({"picture_marks.comp"}, {"BOUNDS"}), mark_({"picture_marks.comp"}) {}

void PictureMarks::resize(int columns, int rows) {
    marks_.resize(columns, rows);
    places_ = gl::Texture(GL_RGBA16UI, marks_.texture().width(), marks_.texture().height());
}

void PictureMarks::place() const {
    glBindImageTexture(0, places_.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA16UI);
    dispatch(bounds_, places_);
}

void PictureMarks::mark(const BlockMarks& picture, const BlockMarks& too) const {
    glBindTextureUnit(0, places_.name());
    glBindTextureUnit(1, picture.texture().name());
    marks_.bind(0);
    too.bind(1);
    dispatch(mark_, places_);
}

} // namespace autostereo::gpu
