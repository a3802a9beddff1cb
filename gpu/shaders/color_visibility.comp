#version 450 core
// Takes out the nodes that the colour camera cannot see: a surface nearer by more than the cut
// stands in its line of sight, so the colour found there belongs to that surface. Nodes that only
// stand close beside such a surface stay, but are marked: depth edges are never exact to the
// pixel, and their colour must not be spread behind it.
#include "mesh_block.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

layout(binding = 0) uniform sampler2D registered; // nearest depth at the colour camera, m; 0: none
layout(binding = 1) uniform sampler2D sources;
layout(rgba32f, binding = 0) uniform image2D points;
layout(r8ui, binding = 1) uniform writeonly uimage2D clean; // 1: the colour is surely its own

const int kGuard = 3; // texels to either side

bool isBehindTexel(float z, ivec2 texel) {
    ivec2 last = textureSize(registered, 0) - 1;
    if (any(lessThan(texel, ivec2(0))) || any(greaterThan(texel, last))) return false;
    float nearest = texelFetch(registered, texel, 0).x;
    return nearest > 0.0 && z > nearest * (1.0 + float(counts.z) * 0.001);
}

void main() {
    ivec2 node = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(node, imageSize(points)))) return;
    float z = imageLoad(points, node).w;
    vec2 size = vec2(textureSize(registered, 0));
    ivec2 texel = ivec2(floor(texelFetch(sources, node, 0).xy * size));
    bool free = z > 0.0;
    for (int x = -kGuard; x <= kGuard && free; ++x) free = !isBehindTexel(z, texel + ivec2(x, 0));
    imageStore(clean, node, uvec4(free ? 1u : 0u));
    if (isBehindTexel(z, texel)) imageStore(points, node, vec4(0.0));
}
