#pragma once

#include "gpu/gl/objects.hpp"

namespace autostereo::gpu::gl {

/// One uniform block; `bind` writes it and puts it at its binding point.
template<class Block>
class UniformBuffer {
  public:
    UniformBuffer() : buffer_(makeBuffer(sizeof(Block), nullptr, GL_DYNAMIC_STORAGE_BIT)) {}
    void bind(GLuint binding, const Block& block) {
        glNamedBufferSubData(buffer_.name(), 0, sizeof(Block), &block);
        glBindBufferBase(GL_UNIFORM_BUFFER, binding, buffer_.name());
    }

  private:
    Buffer buffer_;
};

} // namespace autostereo::gpu::gl
