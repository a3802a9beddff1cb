#include "gpu/fusion/background_memory.hpp"

#include "gpu/gl/dispatch.hpp"

#include <glm/vec2.hpp>

namespace autostereo::gpu {

namespace {
constexpr GLsizeiptr kTallyBytes = sizeof(glm::uvec2); // twice: last frame's and this one's
}

BackgroundMemory::BackgroundMemory()
    : program_({"background_remember.comp"}), tally_(gl::makeBuffer(2 * kTallyBytes, nullptr, 0)) {}

void BackgroundMemory::resize(int columns, int rows) {
    depth_ = gl::Texture(GL_R32F, columns, rows);
    color_ = gl::Texture(GL_RGBA8, columns, rows);
    forget();
}

void BackgroundMemory::forget() const {
    glClearTexImage(depth_.name(), 0, GL_RED, GL_FLOAT, nullptr);
    glClearTexImage(color_.name(), 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glClearNamedBufferData(tally_.name(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
}

void BackgroundMemory::remember(const gl::Texture& sure, const gl::Texture& picture) const {
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glCopyNamedBufferSubData(tally_.name(), tally_.name(), kTallyBytes, 0, kTallyBytes);
    glClearNamedBufferSubData(tally_.name(), GL_R32UI, kTallyBytes, kTallyBytes, GL_RED_INTEGER,
                              GL_UNSIGNED_INT, nullptr);
    glBindTextureUnit(0, sure.name());
    glBindTextureUnit(1, picture.name());
    glBindImageTexture(0, depth_.name(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32F);
    glBindImageTexture(1, color_.name(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA8);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, tally_.name());
    gl::dispatch(program_, depth_.width(), depth_.height());
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

} // namespace autostereo::gpu
