#version 450 core
// The scene layer: a quad for each texel that has depth before the cut, so that a surface reaches to the edges of
// its outermost texels. Corners that four texels of one surface share are one vertex, the others one
// for each texel, which is what cuts surfaces apart. Vertex of a texel's corner (i, j): (2x+i, 2y+j).
#include "mesh_block.glsl"
#include "camera.glsl"
#include "disparity.glsl"
#include "cyclopean_grid.glsl"
#include "layer_corner.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

layout(binding = 0) uniform sampler2D filled;
layout(rgba32f, binding = 0) uniform writeonly image2D points; // u, v, disparity, z
layout(rg32f, binding = 1) uniform writeonly image2D sources;  // texture coordinate
layout(std430, binding = 0) writeonly buffer Indices { uint indices[]; };

// Writes a corner; the number of the vertex that stands for it.
uint corner(ivec2 texel, ivec2 side, float own, ivec2 size) {
    Corner found = cornerOf(filled, texel + side, own, false);
    ivec2 vertex = 2 * texel + side;
    vec2 uv = panelFromTexel(vec2(texel + side) - 0.5);
    imageStore(points, vertex, vec4(uv, found.disparity, found.z));
    imageStore(sources, vertex, vec4(sourceFromPanel(uv), 0.0, 0.0));
    ivec2 owner = texel + side;
    bool one = areOne(found.nearest, found.farthest) && all(lessThan(owner, size));
    ivec2 standing = one ? 2 * owner : vertex;
    return uint(standing.y * 2 * size.x + standing.x);
}

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = textureSize(filled, 0);
    if (any(greaterThanEqual(texel, size))) return;
    float own = texelFetch(filled, texel, 0).x;
    uint at = uint(texel.y * size.x + texel.x) * 6u;
    if (own == 0.0 || isBackdrop(own)) {
        for (uint i = 0u; i < 6u; ++i) indices[at + i] = 0u;
        return;
    }
    uint a = corner(texel, ivec2(0, 0), own, size), b = corner(texel, ivec2(1, 0), own, size);
    uint c = corner(texel, ivec2(0, 1), own, size), d = corner(texel, ivec2(1, 1), own, size);
    indices[at] = a;
    indices[at + 1u] = c;
    indices[at + 2u] = b;
    indices[at + 3u] = b;
    indices[at + 4u] = c;
    indices[at + 5u] = d;
}
