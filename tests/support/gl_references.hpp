#pragma once

#include "gpu/scene/scene_pipeline.hpp"
#include "tests/oracle/hybrid_oracle.hpp"

#include <glm/gtc/packing.hpp>

#include <cstdint>
#include <vector>

namespace autostereo::test {

/// Of an octahedron folded flat: Cigolle et al., "A Survey of Efficient Representations for
/// Independent Unit Vectors", 2014; length one.
inline glm::dvec3 unfolded(std::uint32_t bits) {
    const double x = 2 * ((bits & 0xffffU) / 65535.0) - 1, y = 2 * ((bits >> 16U) / 65535.0) - 1;
    const double z = 1 - std::abs(x) - std::abs(y);
    if (z >= 0) return {x, y, z};
    return {(1 - std::abs(y)) * (x < 0 ? -1 : 1), (1 - std::abs(x)) * (y < 0 ? -1 : 1), z};
}

inline double halfOf(std::uint32_t bits) {
    return static_cast<double>(glm::unpackHalf1x16(static_cast<std::uint16_t>(bits & 0xffffU)));
}

/// What the pipeline's reference viewpoints hold, for seeing it in double precision. Normals are
/// not of length one, as the shaders mix them.
inline oracle::References readReferences(const gpu::ScenePipeline& pipeline) {
    const gpu::SceneSurfaces& surfaces = pipeline.surfaces().value();
    const gpu::SurfacesBlock& block = surfaces.block();
    oracle::References in{block.lattice.x,
                          block.lattice.y,
                          block.lattice.z,
                          block.lattice.w,
                          static_cast<double>(block.lineup.x),
                          static_cast<double>(block.lineup.y),
                          static_cast<double>(block.lineup.z),
                          {}};
    const auto count = static_cast<std::size_t>(in.width) * static_cast<std::size_t>(in.height) *
                       static_cast<std::size_t>(in.count);
    std::vector<float> disparities(count);
    std::vector<glm::uvec4> texels(count);
    glGetTextureImage(surfaces.disparities().name(), 0, GL_RED, GL_FLOAT,
                      static_cast<GLsizei>(4 * count), disparities.data());
    glGetTextureImage(surfaces.surfaces().name(), 0, GL_RGBA_INTEGER, GL_UNSIGNED_INT,
                      static_cast<GLsizei>(16 * count), texels.data());
    const gpu::gl::Texture& parts = pipeline.model().parts();
    std::vector<gpu::ScenePart> materials(static_cast<std::size_t>(parts.width()) *
                                          static_cast<std::size_t>(parts.height()) /
                                          gpu::ScenePart::kTexels);
    glGetTextureImage(parts.name(), 0, GL_RGBA, GL_FLOAT,
                      static_cast<GLsizei>(materials.size() * sizeof(gpu::ScenePart)),
                      materials.data());
    for (std::size_t i = 0; i < count; ++i) {
        const glm::uvec4& texel = texels[i];
        oracle::HybridSurface surface{.disparity = static_cast<double>(disparities[i])};
        if (texel.x != 0) {
            const gpu::ScenePart& part = materials.at(texel.x - 1);
            surface = {1,
                       surface.disparity,
                       unfolded(texel.y),
                       {halfOf(texel.z), halfOf(texel.z >> 16U), halfOf(texel.w)},
                       glm::dvec3(part.specular),
                       glm::dvec3(part.emissive),
                       static_cast<double>(part.diffuse.w)};
        }
        in.texels.push_back(surface);
    }
    return in;
}

/// What a pixel of a view shows, as shaders/scene_root.glsl packs it.
struct ReadRoot {
    enum class Kind { Seen, Nothing, Hole };
    Kind kind;
    int reference = 0;
    double x = 0; ///< texels of the reference
};
inline ReadRoot readRoot(std::uint32_t bits) {
    if (bits >> 28U == 15) return {ReadRoot::Kind::Hole};
    if (bits >> 28U == 14) return {ReadRoot::Kind::Nothing};
    return {ReadRoot::Kind::Seen, static_cast<int>(bits >> 28U), (bits & 0x0fffffffU) / 8192.0};
}

/// The atlas' size, rows from the bottom.
inline std::vector<std::uint32_t> readRoots(const gpu::ScenePipeline& pipeline) {
    const gpu::gl::Texture& roots = pipeline.reprojection().value().roots();
    std::vector<std::uint32_t> bits(static_cast<std::size_t>(roots.width()) *
                                    static_cast<std::size_t>(roots.height()));
    glGetTextureImage(roots.name(), 0, GL_RED_INTEGER, GL_UNSIGNED_INT,
                      static_cast<GLsizei>(4 * bits.size()), bits.data());
    return bits;
}

} // namespace autostereo::test
