#include "gpu/gl/debug_output.hpp"

#include "gpu/gl/api.hpp"

#include <spdlog/spdlog.h>

#include <atomic>

namespace autostereo::gpu::gl {

namespace {

std::atomic<std::uint64_t> errors{0};

void APIENTRY onMessage(GLenum, GLenum type, GLuint id, GLenum severity, GLsizei, const char* text,
                        const void*) {
    if (type == GL_DEBUG_TYPE_ERROR || type == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR) {
        ++errors;
        spdlog::error("gl: {} (message {})", text, id);
    } else if (severity != GL_DEBUG_SEVERITY_NOTIFICATION) {
        spdlog::debug("gl: {} (message {})", text, id);
    }
}

} // namespace

void logDebugOutput() {
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(onMessage, nullptr);
}

std::uint64_t debugErrorCount() { return errors; }

} // namespace autostereo::gpu::gl
