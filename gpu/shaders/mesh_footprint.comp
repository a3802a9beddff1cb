#version 450 core
// Marks the blocks of the cyclopean grid that a cell covers, or covered, of which a node moved.
#include "mesh_block.glsl"
#include "mesh_footprint.glsl"
#include "listed_blocks.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0) uniform sampler2D points; // u, v, disparity, z
layout(binding = 1) uniform sampler2D before;
layout(r8ui, binding = 0) uniform writeonly uimage2D footprint;

void main() {
    ivec2 cell = listedTexel();
    if (any(greaterThanEqual(cell, textureSize(points, 0) - 1))) return;
    vec2 low = vec2(1e9), high = vec2(-1e9);
    bool moved = false;
    for (int i = 0; i < 4; ++i) {
        ivec2 node = cell + ivec2(i & 1, i >> 1);
        vec4 now = texelFetch(points, node, 0), then = texelFetch(before, node, 0);
        moved = moved || now != then;
        vec2 here = texelFromPanel(now.xy), there = texelFromPanel(then.xy);
        if (now.w > 0.0) low = min(low, here), high = max(high, here);
        if (then.w > 0.0) low = min(low, there), high = max(high, there);
    }
    ivec4 place = moved ? blocksBetween(low, high) : ivec4(1, 1, 0, 0);
    for (int y = place.y; y <= place.w; ++y)
        for (int x = place.x; x <= place.z; ++x)
            imageStore(footprint, ivec2(x, y), uvec4(1u));
}
