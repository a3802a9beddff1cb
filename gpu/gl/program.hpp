#pragma once

#include "gpu/gl/objects.hpp"

#include <string>
#include <vector>

namespace autostereo::gpu::gl {

/// A linked program made of embedded shaders; the stage follows from a file's ending (.vert,
/// .frag, .comp). Throws GlError with the compiler's message and the numbered lines around it.
/// Thread-bound to the context.
class Program {
  public:
    Program() = default;
    Program(const std::vector<std::string>& shaders, const std::vector<std::string>& defines = {});
    void use() const { glUseProgram(name_.name()); }
    [[nodiscard]] GLuint name() const { return name_.name(); }

  private:
    ProgramName name_;
};

} // namespace autostereo::gpu::gl
