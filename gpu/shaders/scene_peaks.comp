#version 450 core
// The nearest disparity of each block of a reference's row and of what lies up to a margin beside it:
// no ray to a view between two references meets anything there that is nearer.
layout(local_size_x = 8, local_size_y = 8) in;
#include "scene_parts.glsl"
#include "scene_surfaces.glsl"
layout(binding = 0, r32f) uniform writeonly image2DArray nearest;

void main() {
    ivec3 block = ivec3(gl_GlobalInvocationID);
    if (any(greaterThanEqual(block, imageSize(nearest)))) return;
    int first = block.x * kPeakBlock - lattice.y - 2;
    int last = (block.x + 1) * kPeakBlock + lattice.y + 1;
    float peak = span.y;
    for (int column = max(first, 0); column <= min(last, lattice.x - 1); ++column)
        peak = max(peak, disparityAt(block.z, column, block.y));
    imageStore(nearest, block, vec4(peak));
}
