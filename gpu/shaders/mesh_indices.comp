#version 450 core
// Two triangles per cell, always in the same place of the buffer, 8 x 8 cells after another; those
// with a missing corner, or that bridge two surfaces, become points (three equal indices), which draw
// nothing. And takes down where nodes stand, for the next time.
#include "mesh_block.glsl"
#include "listed_blocks.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0) uniform sampler2D points;
layout(binding = 1) uniform usampler2D depthCounts;
layout(rgba32f, binding = 0) uniform writeonly image2D before;
layout(std430, binding = 0) writeonly buffer Indices { uint indices[]; };

bool isDrawn(ivec2 a, ivec2 b, ivec2 c) {
    bool whole = texelFetch(points, a, 0).w > 0.0 && texelFetch(points, b, 0).w > 0.0 &&
                 texelFetch(points, c, 0).w > 0.0;
    uint za = texelFetch(depthCounts, a, 0).x;
    uint zb = texelFetch(depthCounts, b, 0).x;
    uint zc = texelFetch(depthCounts, c, 0).x;
    return whole && !isCut(min(za, min(zb, zc)), max(za, max(zb, zc)));
}

void store(uint at, ivec2 a, ivec2 b, ivec2 c, bool isCell, int width) {
    bool drawn = isCell && isDrawn(a, b, c);
    uint first = uint(a.y * width + a.x);
    indices[at] = first;
    indices[at + 1u] = drawn ? uint(b.y * width + b.x) : first;
    indices[at + 2u] = drawn ? uint(c.y * width + c.x) : first;
}

void main() {
    ivec2 size = textureSize(points, 0), texel = listedTexel();
    if (all(lessThan(texel, size))) imageStore(before, texel, texelFetch(points, texel, 0));
    bool isCell = all(lessThan(texel, size - 1)); // else one beside it stands in, undrawn
    ivec2 cell = min(texel, size - 2);
    uint at = (blocks[gl_WorkGroupID.x] * 64u + gl_LocalInvocationIndex) * 6u;
    ivec2 right = cell + ivec2(1, 0), below = cell + ivec2(0, 1), across = cell + ivec2(1, 1);
    store(at, cell, below, right, isCell, size.x);
    store(at + 3u, right, below, across, isCell, size.x);
}
