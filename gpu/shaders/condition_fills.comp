#version 450 core
// RESET: no pixel of the listed blocks was filled yet. Else, one work group: sums up the blocks.
#include "condition_fills.glsl"

#ifdef RESET
#include "listed_blocks.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

void main() {
    fills[2u * blocks[gl_WorkGroupID.x]] = 0u;
    fills[2u * blocks[gl_WorkGroupID.x] + 1u] = 0u;
}
#else
#include "condition_tally.glsl"

layout(local_size_x = 64) in;

void main() {
    uvec2 sum = uvec2(0u);
    for (uint i = gl_LocalInvocationID.x; i < uint(fills.length()) / 2u; i += 64u)
        sum += uvec2(fills[2u * i], fills[2u * i + 1u]);
    atomicAdd(tallies[kFilled], sum.x);
    atomicAdd(tallies[kHoles], sum.y);
}
#endif
