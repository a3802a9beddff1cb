#version 450 core
// Which blocks of the cyclopean grid the cells of a block of the depth grid lie in; of blocks that
// changed only, others are as they were.
#include "mesh_block.glsl"
#include "mesh_footprint.glsl"

layout(local_size_x = 64) in;

layout(binding = 0) uniform sampler2D points;
layout(binding = 1) uniform usampler2D changed; // a texel a block; one texel: of all
layout(rgba16ui, binding = 0) uniform writeonly uimage2D bounds; // first, last

void main() {
    int number = int(gl_GlobalInvocationID.x);
    ivec2 size = imageSize(bounds), block = ivec2(number % size.x, number / size.x);
    if (block.y >= size.y) return;
    ivec2 past = textureSize(changed, 0) - 1;
    uint found = 0u;
    for (int i = 0; i < 9; ++i) // a node belongs to cells of up to four blocks
        found |= texelFetch(changed, clamp(block + ivec2(i % 3, i / 3) - 1, ivec2(0), past), 0).x;
    vec2 low = vec2(1e9), high = vec2(-1e9);
    ivec2 last = textureSize(points, 0) - 1;
    for (int i = 0; i < (found != 0u ? 81 : 0); ++i) { // nodes of 8 x 8 cells
        vec4 node = texelFetch(points, min(block * 8 + ivec2(i % 9, i / 9), last), 0);
        vec2 place = texelFromPanel(node.xy);
        if (node.w > 0.0) low = min(low, place), high = max(high, place);
    }
    if (found != 0u) imageStore(bounds, block, uvec4(blocksBetween(low, high)));
}
