#include "gpu/gl/lost_context.hpp"

#include "gpu/gl/api.hpp"
#include "gpu/gl/error.hpp"

namespace autostereo::gpu::gl {

void throwIfReset() {
    switch (glGetGraphicsResetStatus()) {
    case GL_NO_ERROR:
        return;
    case GL_GUILTY_CONTEXT_RESET:
        throw PanelLost("gl: the GPU was reset over what this program gave it to do");
    case GL_INNOCENT_CONTEXT_RESET:
        throw PanelLost("gl: the GPU was reset over another program");
    default:
        throw PanelLost("gl: the GPU was reset");
    }
}

} // namespace autostereo::gpu::gl
