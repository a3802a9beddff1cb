#include "gpu/fusion/pull_push.hpp"

#include "gpu/gl/dispatch.hpp"

namespace autostereo::gpu {

namespace {

void visit(const gl::Program& program, const gl::Texture& from, const gl::Texture& to,
           GLenum access) {
    glBindTextureUnit(0, from.name());
    glBindImageTexture(0, to.name(), 0, GL_FALSE, 0, access, GL_RGBA32F);
    gl::dispatch(program, to.width(), to.height());
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

} // namespace

PullPush::PullPush(std::size_t sharpLevels)
    : sharpLevels_(sharpLevels), pull_({"pull.comp"}), pullSharp_({"pull.comp"}, {"SHARP"}),
      push_({"push.comp"}), finish_({"push.comp"}, {"COARSEST"}) {}

void PullPush::resize(int width, int height) {
    levels_.clear();
    while (true) {
        levels_.emplace_back(GL_RGBA32F, width, height);
        levels_.back().setFilter(GL_LINEAR);
        if (width == 1 && height == 1) return;
        width = (width + 1) / 2;
        height = (height + 1) / 2;
    }
}

void PullPush::spread() const {
    for (std::size_t i = 1; i < levels_.size(); ++i)
        visit(i <= sharpLevels_ ? pullSharp_ : pull_, levels_[i - 1], levels_[i], GL_WRITE_ONLY);
    visit(finish_, levels_.back(), levels_.back(), GL_READ_WRITE);
    for (std::size_t i = levels_.size() - 1; i > 0; --i)
        visit(push_, levels_[i], levels_[i - 1], GL_READ_WRITE);
}

} // namespace autostereo::gpu
