#version 450 core
// The nearest corner (largest disparity) in each block of a row of quads, of both layers.
#include "layer_search.glsl"
#include "listed_blocks.glsl"

layout(local_size_x = 8, local_size_y = 8) in; // half of it idle: 2 blocks, 8 rows, 2 layers

layout(binding = 0) uniform sampler2D quads;
layout(r32f, binding = 0) uniform writeonly image2D tops;

void main() {
    ivec2 size = textureSize(quads, 0), local = ivec2(gl_LocalInvocationID.xy);
    if (local.x >= 4) return;
    int row = listedBlock().y * 8 + local.y, rows = size.y / 2;
    ivec2 block = ivec2(listedBlock().x * 8 / kBlock + (local.x & 1), row + (local.x >> 1) * rows);
    if (row >= rows || block.x >= imageSize(tops).x) return;
    float top = kNoSurface;
    for (int i = 0; i < kBlock; ++i) {
        vec4 quad = texelFetch(quads, ivec2(min(block.x * kBlock + i, size.x - 1), block.y), 0);
        top = max(top, max(max(quad.x, quad.y), max(quad.z, quad.w)));
    }
    imageStore(tops, block, vec4(top));
}
