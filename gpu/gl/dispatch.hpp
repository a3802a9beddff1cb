#pragma once

#include "gpu/gl/program.hpp"

namespace autostereo::gpu::gl {

/// One invocation per element of a grid, in groups of 16 x 16 as every compute shader here
/// declares.
inline void dispatch(const Program& program, int width, int height) {
    program.use();
    glDispatchCompute(static_cast<GLuint>(width + 15) / 16, static_cast<GLuint>(height + 15) / 16,
                      1);
}

} // namespace autostereo::gpu::gl
