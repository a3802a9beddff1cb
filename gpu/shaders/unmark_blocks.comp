#version 450 core
// Takes the marks of listed blocks away, and counts the blocks.
#include "listed_blocks.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(r8ui, binding = 0) uniform writeonly uimage2D marks;

layout(std430, binding = 1) buffer Counters { uint counted; };

void main() {
    if (gl_LocalInvocationIndex != 0u) return;
    imageStore(marks, listedBlock(), uvec4(0u));
    atomicAdd(counted, 1u);
}
