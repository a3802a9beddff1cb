#pragma once

#include "gpu/atlas.hpp"

#include <cstddef>
#include <span>

namespace autostereo::gpu {

/// RGBA pixels, 8 bits a channel, top row first.
struct QuiltPicture {
    int width = 0;
    int height = 0;
    std::span<const std::byte> pixels;
};

/// An atlas filled from a quilt. Tiles are floor(picture / count); what is left over lies at the
/// right and at the top. Throws GlError.
[[nodiscard]] Atlas quiltAtlas(const QuiltPicture& quilt, const AtlasLayout& layout);

} // namespace autostereo::gpu
