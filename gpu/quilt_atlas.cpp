#include "gpu/quilt_atlas.hpp"

namespace autostereo::gpu {

Atlas quiltAtlas(const QuiltPicture& quilt, const AtlasLayout& layout) {
    Atlas atlas(layout);
    const auto stride = 4 * static_cast<std::size_t>(quilt.width);
    for (int row = 0; row < layout.height(); ++row) { // from the bottom, as textures have it
        const auto top = static_cast<std::size_t>(quilt.height - 1 - row);
        glTextureSubImage2D(atlas.color().name(), 0, 0, row, layout.width(), 1, GL_RGBA,
                            GL_UNSIGNED_BYTE, quilt.pixels.subspan(top * stride, stride).data());
    }
    return atlas;
}

} // namespace autostereo::gpu
