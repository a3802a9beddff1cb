#version 450 core
// The nearest corner (largest disparity) in each block of a row: of quads (QUADS), else of smaller blocks.
#include "layer_search.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

layout(binding = 0) uniform sampler2D fine;
layout(r32f, binding = 0) uniform writeonly image2D tops;

void main() {
    ivec2 block = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(block, imageSize(tops)))) return;
    int last = textureSize(fine, 0).x - 1;
    float top = kNoSurface;
    for (int i = 0; i < PARTS; ++i) {
        vec4 part = texelFetch(fine, ivec2(min(block.x * PARTS + i, last), block.y), 0);
#ifdef QUADS
        top = max(top, max(max(part.x, part.y), max(part.z, part.w)));
#else
        top = max(top, part.x);
#endif
    }
    imageStore(tops, block, vec4(top));
}
