#include "gpu/gl/program.hpp"

#include "gpu/gl/error.hpp"
#include "gpu/gl/shader_source.hpp"

#include <algorithm>
#include <sstream>

namespace autostereo::gpu::gl {

namespace {

GLenum stageOf(const std::string& file) {
    if (file.ends_with(".vert")) return GL_VERTEX_SHADER;
    if (file.ends_with(".frag")) return GL_FRAGMENT_SHADER;
    if (file.ends_with(".geom")) return GL_GEOMETRY_SHADER;
    if (file.ends_with(".comp")) return GL_COMPUTE_SHADER;
    throw GlError("gl: no shader stage for " + file);
}

/// Mesa prints source number 0 for every include, so the expanded text is what a reader needs.
std::string numbered(const std::string& source) {
    std::istringstream lines(source);
    std::ostringstream out;
    int number = 0;
    for (std::string line; std::getline(lines, line);)
        out << ++number << ": " << line << '\n';
    return out.str();
}

template<class Read>
std::string infoLog(GLuint name, GLint length, Read read) {
    std::string text(static_cast<std::size_t>(std::max(length, 1)), '\0');
    GLsizei written = 0; // without the closing zero that `length` counts
    read(name, length, &written, text.data());
    text.resize(static_cast<std::size_t>(written));
    return text;
}

ShaderName compile(const std::string& file, const std::vector<std::string>& defines) {
    const std::string source = shaderSource(file, defines);
    ShaderName shader(glCreateShader(stageOf(file)));
    const char* text = source.c_str();
    glShaderSource(shader.name(), 1, &text, nullptr);
    glCompileShader(shader.name());
    GLint good = 0, length = 0;
    glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &good);
    if (good == GL_TRUE) return shader;
    glGetShaderiv(shader.name(), GL_INFO_LOG_LENGTH, &length);
    throw GlError("gl: cannot compile " + file + ": " +
                  infoLog(shader.name(), length, glGetShaderInfoLog) + '\n' + numbered(source));
}

} // namespace

Program::Program(const std::vector<std::string>& shaders, const std::vector<std::string>& defines)
    : name_(glCreateProgram()) {
    for (const std::string& file : shaders) {
        const ShaderName shader = compile(file, defines);
        glAttachShader(name(), shader.name());
    }
    glLinkProgram(name());
    GLint good = 0, length = 0;
    glGetProgramiv(name(), GL_LINK_STATUS, &good);
    if (good == GL_TRUE) return;
    glGetProgramiv(name(), GL_INFO_LOG_LENGTH, &length);
    throw GlError("gl: cannot link " + shaders.front() + ": " +
                  infoLog(name(), length, glGetProgramInfoLog));
}

} // namespace autostereo::gpu::gl
