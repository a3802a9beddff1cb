#version 450 core
// Triangles of the mesh that reach into a marked block of the cyclopean grid. LIST, one work group:
// their blocks of cells in order, and the command that draws them. Else: their indices, one after
// the other.
const uint kIndices = 384u; // of 8 x 8 cells

#ifdef LIST
layout(local_size_x = 256) in;

layout(binding = 0) uniform usampler2D bounds;
layout(binding = 1) uniform usampler2D footprint;
layout(std430, binding = 6) buffer ListedBlocks {
    uint groups, groupsY, groupsZ, blocksAcross;
    uint blocks[];
};
layout(std430, binding = 7) buffer DrawCommand { uint count, instances, firstIndex, firstNode, first; };

shared uint found[256];

bool isPicked(ivec2 block) {
    ivec4 place = ivec4(texelFetch(bounds, block, 0));
    uint any = 0u;
    for (int y = place.y; y <= place.w && any == 0u; ++y)
        for (int x = place.x; x <= place.z && any == 0u; ++x)
            any = texelFetch(footprint, ivec2(x, y), 0).x;
    return any != 0u;
}

void main() {
    ivec2 size = textureSize(bounds, 0);
    int own = int(gl_LocalInvocationID.x), all = size.x * size.y, each = (all + 255) / 256;
    int from = own * each, past = min(from + each, all);
    uint picked = 0u;
    for (int i = from; i < past; ++i)
        if (isPicked(ivec2(i % size.x, i / size.x))) ++picked;
    found[own] = picked;
    barrier();
    uint at = 0u;
    for (int i = 0; i < own; ++i)
        at += found[i];
    for (int i = from; i < past; ++i)
        if (isPicked(ivec2(i % size.x, i / size.x))) blocks[at++] = uint(i);
    if (own != 255) return;
    groups = at;
    count = at * kIndices;
}
#else
#include "listed_blocks.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(std430, binding = 0) readonly buffer Indices { uint indices[]; };
layout(std430, binding = 1) writeonly buffer Picked { uint picked[]; };

void main() {
    uint own = gl_LocalInvocationIndex * 6u;
    uint from = blocks[gl_WorkGroupID.x] * kIndices + own, to = gl_WorkGroupID.x * kIndices + own;
    for (uint i = 0u; i < 6u; ++i)
        picked[to + i] = indices[from + i];
}
#endif
