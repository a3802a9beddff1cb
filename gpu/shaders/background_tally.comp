#version 450 core
// RESET: no texel of the listed blocks was compared yet. MOVED, one work group: where the camera was
// moved the next frame sees to all blocks. Else, one work group: sums up the blocks.
#include "background_tally.glsl"

#ifdef RESET
#include "listed_blocks.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

void main() { compared[blocks[gl_WorkGroupID.x]] = 0u; }
#else
layout(local_size_x = 64) in;

layout(r8ui, binding = 2) uniform writeonly uimage2D changed;

void main() {
    ivec2 size = imageSize(changed);
    int first = int(gl_LocalInvocationID.x), past = size.x * size.y;
#ifdef MOVED
    if (!isMoved(now)) past = 0;
    for (int i = first; i < past; i += 64)
        imageStore(changed, ivec2(i % size.x, i / size.x), uvec4(1u));
#else
    uint sum = 0u;
    for (int i = first; i < past; i += 64)
        sum += compared[i];
    atomicAdd(now.x, sum);
#endif
}
#endif
