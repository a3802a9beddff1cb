#version 450 core
// Two triangles per cell, always in the same place of the buffer; those with a missing corner, or
// that bridge two surfaces, become points (three equal indices), which draw nothing.
#include "mesh_block.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

layout(binding = 0) uniform sampler2D points;
layout(binding = 1) uniform usampler2D depthCounts;
layout(std430, binding = 0) writeonly buffer Indices { uint indices[]; };

bool isDrawn(ivec2 a, ivec2 b, ivec2 c) {
    bool whole = texelFetch(points, a, 0).w > 0.0 && texelFetch(points, b, 0).w > 0.0 &&
                 texelFetch(points, c, 0).w > 0.0;
    uint za = texelFetch(depthCounts, a, 0).x;
    uint zb = texelFetch(depthCounts, b, 0).x;
    uint zc = texelFetch(depthCounts, c, 0).x;
    return whole && !isCut(min(za, min(zb, zc)), max(za, max(zb, zc)));
}

void store(uint at, ivec2 a, ivec2 b, ivec2 c, int width) {
    bool drawn = isDrawn(a, b, c);
    uint first = uint(a.y * width + a.x);
    indices[at] = first;
    indices[at + 1u] = drawn ? uint(b.y * width + b.x) : first;
    indices[at + 2u] = drawn ? uint(c.y * width + c.x) : first;
}

void main() {
    ivec2 size = textureSize(points, 0);
    ivec2 cell = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(cell, size - 1))) return;
    uint at = uint(cell.y * (size.x - 1) + cell.x) * 6u;
    ivec2 right = cell + ivec2(1, 0), below = cell + ivec2(0, 1), across = cell + ivec2(1, 1);
    store(at, cell, below, right, size.x);
    store(at + 3u, right, below, across, size.x);
}
