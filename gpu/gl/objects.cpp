#include "gpu/gl/objects.hpp"

#include "gpu/gl/error.hpp"

#include <algorithm>
#include <bit>
#include <string>

namespace autostereo::gpu::gl {

namespace {

std::int64_t bufferBytes(GLuint name) {
    GLint64 bytes = 0;
    glGetNamedBufferParameteri64v(name, GL_BUFFER_SIZE, &bytes);
    return bytes;
}

std::int64_t textureBytes(GLuint name) {
    GLint levels = 0;
    glGetTextureParameteriv(name, GL_TEXTURE_IMMUTABLE_LEVELS, &levels);
    std::int64_t bytes = 0;
    for (GLint level = 0; level < levels; ++level) {
        const auto of = [&](GLenum what) {
            GLint value = 0;
            glGetTextureLevelParameteriv(name, level, what, &value);
            return static_cast<std::int64_t>(value);
        };
        std::int64_t bits = 0;
        for (const GLenum size : {GL_TEXTURE_RED_SIZE, GL_TEXTURE_GREEN_SIZE, GL_TEXTURE_BLUE_SIZE,
                                  GL_TEXTURE_ALPHA_SIZE, GL_TEXTURE_DEPTH_SIZE})
            bits += of(size);
        bytes += of(GL_TEXTURE_WIDTH) * of(GL_TEXTURE_HEIGHT) * of(GL_TEXTURE_DEPTH) * bits / 8;
    }
    return bytes;
}

GLuint makeTexture(GLenum target) {
    GLuint name = 0;
    glCreateTextures(target, 1, &name);
    return name;
}

} // namespace

void deleteBuffer(GLuint name) {
    detail::bytesAlive -= bufferBytes(name);
    glDeleteBuffers(1, &name);
}

void deleteTexture(GLuint name) {
    detail::bytesAlive -= textureBytes(name);
    glDeleteTextures(1, &name);
}

Texture::Texture(GLenum internalFormat, int width, int height)
    : handle_(makeTexture(GL_TEXTURE_2D)), width_(width), height_(height) {
    glTextureStorage2D(name(), 1, internalFormat, width, height);
    initialise();
}

Texture::Texture(GLenum internalFormat, int width, int height, int layers)
    : handle_(makeTexture(GL_TEXTURE_2D_ARRAY)), width_(width), height_(height) {
    glTextureStorage3D(name(), 1, internalFormat, width, height, layers);
    initialise();
}

Texture Texture::withLevels(GLenum internalFormat, int width, int height) {
    Texture texture;
    texture.handle_ = Handle<deleteTexture>(makeTexture(GL_TEXTURE_2D));
    texture.width_ = width;
    texture.height_ = height;
    const auto levels = std::bit_width(static_cast<unsigned>(std::max(width, height)));
    glTextureStorage2D(texture.name(), static_cast<GLsizei>(levels), internalFormat, width, height);
    texture.initialise();
    glTextureParameteri(texture.name(), GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTextureParameteri(texture.name(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTextureParameteri(texture.name(), GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTextureParameteri(texture.name(), GL_TEXTURE_WRAP_T, GL_REPEAT);
    return texture;
}

void Texture::initialise() const {
    detail::bytesAlive += textureBytes(name());
    setFilter(GL_NEAREST);
    glTextureParameteri(name(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTextureParameteri(name(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void Texture::setFilter(GLint filter) const {
    glTextureParameteri(name(), GL_TEXTURE_MIN_FILTER, filter);
    glTextureParameteri(name(), GL_TEXTURE_MAG_FILTER, filter);
}

Buffer makeBuffer(std::size_t bytes, const void* data, GLbitfield flags) {
    GLuint name = 0;
    glCreateBuffers(1, &name);
    Buffer buffer(name);
    glNamedBufferStorage(name, static_cast<GLsizeiptr>(bytes), data, flags);
    detail::bytesAlive += bufferBytes(name);
    return buffer;
}

VertexArray makeVertexArray() {
    GLuint name = 0;
    glCreateVertexArrays(1, &name);
    return VertexArray(name);
}

Framebuffer makeFramebuffer(const Texture& color, const Texture* depth) {
    GLuint name = 0;
    glCreateFramebuffers(1, &name);
    Framebuffer framebuffer(name);
    glNamedFramebufferTexture(name, GL_COLOR_ATTACHMENT0, color.name(), 0);
    if (depth != nullptr) glNamedFramebufferTexture(name, GL_DEPTH_ATTACHMENT, depth->name(), 0);
    const GLenum status = glCheckNamedFramebufferStatus(name, GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE)
        throw GlError("gl: framebuffer of " + std::to_string(color.width()) + "x" +
                      std::to_string(color.height()) + " is not complete (status " +
                      std::to_string(status) + "): does the driver allow this size?");
    return framebuffer;
}

} // namespace autostereo::gpu::gl
