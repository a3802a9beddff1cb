#pragma once

#include "devices/frame.hpp"
#include "gpu/blocks.hpp"
#include "gpu/dirty/block_marks.hpp"
#include "gpu/gl/program.hpp"
#include "gpu/gl/uniform_buffer.hpp"

#include <map>
#include <utility>

namespace autostereo::gpu {

/// A colour camera's bytes, as they came -> RGBA8. Programs are made when their format first comes.
/// Thread-bound.
class ColorConverter {
  public:
    /// Whether pixels take part of their colour from the ones beside them.
    [[nodiscard]] static bool sharesChroma(devices::PixelFormat format);
    /// Whether a format has to be converted; else it can be uploaded as it is.
    [[nodiscard]] static bool converts(devices::PixelFormat format);
    /// Rows and columns of the texture that holds a frame's bytes, R8.
    struct ByteGrid {
        int columns = 0;
        int rows = 0;
    };
    [[nodiscard]] static ByteGrid byteGrid(const devices::FrameMetadata& frame);

    /// `bytes`: a texture as `byteGrid` says; `color` has the frame's size. `marks`, where given:
    /// blocks where `color` becomes another than it was are marked.
    void convert(const devices::FrameMetadata& frame, GLuint bytes, const gl::Texture& color,
                 const BlockMarks* marks = nullptr);

  private:
    const gl::Program& program(devices::PixelFormat format, bool marks);

    std::map<std::pair<devices::PixelFormat, bool>, gl::Program> programs_;
    gl::UniformBuffer<ColorBlock> uniforms_;
};

/// What the shader multiplies with, from the frame's matrix and range or what they default to.
[[nodiscard]] ColorBlock colorBlock(const devices::FrameMetadata& frame);

} // namespace autostereo::gpu
