#version 450 core
// Coarse grid behind the scene: each node takes the farthest measurement of clean colour around its
// pixel, which also steps over the mixed pixels at an edge. Output: count (0: none), source pixel, and whether
// anything was measured: what is measured but hidden has a surface, yet no colour of its own.
#include "mesh_block.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

layout(binding = 0) uniform usampler2D clean; // 1: the colour camera sees it, away from edges
layout(binding = 1) uniform usampler2D depthCounts;
layout(rgba16ui, binding = 0) uniform writeonly uimage2D samples;

void main() {
    ivec2 node = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(node, imageSize(samples)))) return;
    ivec2 last = textureSize(depthCounts, 0) - 1;
    ivec2 center = min(node * BACKGROUND, last);
    uvec4 farthest = uvec4(0u);
    for (int y = -BACKGROUND; y <= BACKGROUND; ++y) {
        for (int x = -BACKGROUND; x <= BACKGROUND; ++x) {
            ivec2 pixel = center + ivec2(x, y);
            if (any(lessThan(pixel, ivec2(0))) || any(greaterThan(pixel, last))) continue;
            uint count = texelFetch(depthCounts, pixel, 0).x;
            farthest.w = isMeasured(count) ? 1u : farthest.w;
            if (count > farthest.x && texelFetch(clean, pixel, 0).x == 1u)
                farthest.xyz = uvec3(count, pixel);
        }
    }
    imageStore(samples, node, farthest);
}
