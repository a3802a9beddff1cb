#version 450 core
// Where a ray may have come upon something that changed: a block of a row is stale if any block within
// reach of it changed, in either layer.
#include "mesh_block.glsl"
#include "layer_search.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

layout(binding = 0) uniform usampler2D changed; // scene's rows, then the background's
layout(r8ui, binding = 0) uniform writeonly uimage2D stale;

void main() {
    ivec2 block = ivec2(gl_GlobalInvocationID.xy), size = imageSize(stale);
    if (any(greaterThanEqual(block, size))) return;
    // Eyes are within [-1, 1], walks a texel longer than the budget (first_hit.glsl).
    float texels = max(abs(budget.x), abs(budget.y)) * grid.x / (1.0 + 2.0 * grid.z) + 2.0;
    int reach = int(ceil(texels / float(kBlock)));
    uint found = 0u;
    for (int x = max(block.x - reach, 0); x <= min(block.x + reach, size.x - 1) && found == 0u; ++x)
        found = texelFetch(changed, ivec2(x, block.y), 0).x |
                texelFetch(changed, ivec2(x, block.y + size.y), 0).x;
    imageStore(stale, block, uvec4(found));
}
