#include "gpu/fusion/background_memory.hpp"

#include <glm/vec2.hpp>

namespace autostereo::gpu {

namespace {
constexpr GLsizeiptr kTallyBytes = sizeof(glm::uvec2); // twice: last frame's and this one's
}

BackgroundMemory::BackgroundMemory()
    : program_({"background_remember.comp"}), reset_({"background_tally.comp"}, {"RESET"}),
      sum_({"background_tally.comp"}), moved_({"background_tally.comp"}, {"MOVED"}) {}

void BackgroundMemory::resize(int columns, int rows) {
    depth_ = gl::Texture(GL_R32F, columns, rows);
    color_ = gl::Texture(GL_RGBA8, columns, rows);
    changed_.resize(columns, rows);
    list_.resize(columns, rows);
    const auto blocks =
        static_cast<std::size_t>(list_.across()) * static_cast<std::size_t>(list_.down());
    tally_ = gl::makeBuffer(2 * kTallyBytes + blocks * sizeof(GLuint), nullptr, 0);
    forget();
}

void BackgroundMemory::forget() {
    glClearTexImage(depth_.name(), 0, GL_RED, GL_FLOAT, nullptr);
    glClearTexImage(color_.name(), 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glClearNamedBufferData(tally_.name(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
    forgot_ = true;
}

void BackgroundMemory::remember(const gl::Texture& sure, const BlockMarks& sureMarks,
                                const gl::Texture& picture, const BlockMarks& pictureMarks,
                                BlockLister& lister, bool everything) {
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glCopyNamedBufferSubData(tally_.name(), tally_.name(), kTallyBytes, 0, kTallyBytes);
    glClearNamedBufferSubData(tally_.name(), GL_R32UI, kTallyBytes, kTallyBytes, GL_RED_INTEGER,
                              GL_UNSIGNED_INT, nullptr);
    if (everything || forgot_)
        list_.listAll();
    else
        lister.list(list_, {{sureMarks}, {pictureMarks}, {changed_}});
    forgot_ = false;
    changed_.clear();
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, tally_.name());
    list_.dispatch(reset_);
    glBindTextureUnit(0, sure.name());
    glBindTextureUnit(1, picture.name());
    glBindImageTexture(0, depth_.name(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32F);
    glBindImageTexture(1, color_.name(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA8);
    changed_.bind(2);
    list_.dispatch(program_);
    sumUp();
}

void BackgroundMemory::sumUp() const {
    for (const gl::Program* program : {&sum_, &moved_}) {
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
        program->use();
        glDispatchCompute(1, 1, 1);
    }
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

} // namespace autostereo::gpu
