#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace autostereo::gpu::gl {

/// Text of an embedded shader with one level of `#include "x.glsl"` expanded and `defines`
/// ("NAME VALUE") put behind its #version line. Throws GlError for an unknown name.
[[nodiscard]] std::string shaderSource(std::string_view name,
                                       const std::vector<std::string>& defines);

} // namespace autostereo::gpu::gl
