#version 450 core
// The nearest corner (largest disparity) in each block of a row of quads.
#include "layer_search.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

layout(binding = 0) uniform sampler2D quads;
layout(r32f, binding = 0) uniform writeonly image2D tops;

void main() {
    ivec2 block = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(block, imageSize(tops)))) return;
    int last = textureSize(quads, 0).x - 1;
    float top = kNoSurface;
    for (int i = 0; i < kBlock; ++i) {
        vec4 quad = texelFetch(quads, ivec2(min(block.x * kBlock + i, last), block.y), 0);
        top = max(top, max(max(quad.x, quad.y), max(quad.z, quad.w)));
    }
    imageStore(tops, block, vec4(top));
}
