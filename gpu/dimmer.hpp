#pragma once

#include "gpu/gl/objects.hpp"
#include "gpu/gl/program.hpp"

namespace autostereo::gpu {

/// Makes what a panel shows darker, on the screen's own scale. Thread-bound.
class Dimmer {
  public:
    /// Throws GlError.
    Dimmer();

    /// Lower left corner and size of what is dimmed, pixels.
    struct Area {
        int x, y, width, height;
    };
    /// Multiplies every level by `brightness`, 0 to 1, rounded to the nearest.
    void dim(GLuint framebuffer, const Area& area, double brightness);

  private:
    gl::Program program_;
    gl::VertexArray vertexArray_;
};

} // namespace autostereo::gpu
