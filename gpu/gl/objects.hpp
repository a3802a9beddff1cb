#pragma once

#include "gpu/gl/api.hpp"
#include "gpu/gl/usage.hpp"

#include <cstddef>
#include <utility>

namespace autostereo::gpu::gl {

/// Owns one GL name; movable, moves are destructive. Thread-bound to the context.
template<void (*Delete)(GLuint)>
class Handle {
  public:
    Handle() = default;
    explicit Handle(GLuint name) : name_(name) {
        if (name_ != 0) ++detail::objectsAlive;
    }
    Handle(Handle&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    ~Handle() {
        if (name_ == 0) return;
        Delete(name_);
        --detail::objectsAlive;
    }
    [[nodiscard]] GLuint name() const { return name_; }

  private:
    GLuint name_ = 0;
};

void deleteBuffer(GLuint name);
void deleteTexture(GLuint name);
inline void deleteFramebuffer(GLuint name) { glDeleteFramebuffers(1, &name); }
inline void deleteVertexArray(GLuint name) { glDeleteVertexArrays(1, &name); }
inline void deleteQuery(GLuint name) { glDeleteQueries(1, &name); }
inline void deleteProgram(GLuint name) { glDeleteProgram(name); }
inline void deleteShader(GLuint name) { glDeleteShader(name); }
inline void deleteSampler(GLuint name) { glDeleteSamplers(1, &name); }

using Buffer = Handle<deleteBuffer>;
using Framebuffer = Handle<deleteFramebuffer>;
using VertexArray = Handle<deleteVertexArray>;
using Query = Handle<deleteQuery>;
using ProgramName = Handle<deleteProgram>;
using ShaderName = Handle<deleteShader>;
using Sampler = Handle<deleteSampler>;

/// A 2-D texture, or several in layers, with immutable storage; knows its size.
class Texture {
  public:
    Texture() = default;
    Texture(GLenum internalFormat, int width, int height);
    /// GL_TEXTURE_2D_ARRAY.
    Texture(GLenum internalFormat, int width, int height, int layers);
    /// With all its smaller levels, for glGenerateTextureMipmap; repeats, is filtered between them.
    [[nodiscard]] static Texture withLevels(GLenum internalFormat, int width, int height);
    [[nodiscard]] GLuint name() const { return handle_.name(); }
    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] bool isSized(int width, int height) const {
        return width_ == width && height_ == height;
    }
    /// GL_NEAREST (initial) or GL_LINEAR; edges clamp.
    void setFilter(GLint filter) const;

  private:
    void initialise() const;

    Handle<deleteTexture> handle_;
    int width_ = 0;
    int height_ = 0;
};

[[nodiscard]] Buffer makeBuffer(std::size_t bytes, const void* data, GLbitfield flags);
[[nodiscard]] VertexArray makeVertexArray();
/// Throws GlError where the attachments make no complete framebuffer; `depth` may be absent.
[[nodiscard]] Framebuffer makeFramebuffer(const Texture& color, const Texture* depth = nullptr);

} // namespace autostereo::gpu::gl
