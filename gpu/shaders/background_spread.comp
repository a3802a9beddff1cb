#version 450 core
// What a view uncovers beside a near object is the surface across its edge: each node takes the
// nearest node of its row that lies a cut farther away, within the reach of the disparity budget;
// a node without depth takes that of the farther of its neighbours, else the far limit; where
// nothing was measured (not merely hidden) it keeps its own colour, which the camera did see.
#include "mesh_block.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

layout(binding = 0) uniform usampler2D reduced;
layout(binding = 1) uniform usampler2D depthCounts; // for its size
layout(rgba16ui, binding = 0) uniform writeonly uimage2D samples;

bool isBehind(uint own, uint other) {
    return other > 0u && (own == 0u || (other > own && isCut(own, other)));
}

void main() {
    ivec2 node = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(samples);
    if (any(greaterThanEqual(node, size))) return;
    uvec4 own = texelFetch(reduced, node, 0);
    uvec4 found[2] = uvec4[2](uvec4(0u), uvec4(0u));
    int steps[2] = int[2](size.x, size.x);
    for (int side = 0; side < 2; ++side) {
        int direction = 2 * side - 1;
        for (int step = 1; step <= int(counts.w); ++step) {
            int x = node.x + direction * step;
            if (x < 0 || x >= size.x) break;
            uvec4 other = texelFetch(reduced, ivec2(x, node.y), 0);
            if (isBehind(own.x, other.x)) {
                found[side] = other;
                steps[side] = step;
                break;
            }
        }
    }
    bool rightFarther = found[1].x > found[0].x;
    bool rightNearer = steps[1] < steps[0] || (steps[1] == steps[0] && rightFarther);
    uvec4 across = (own.x == 0u ? rightFarther : rightNearer) ? found[1] : found[0];
    uvec4 chosen = across.x > 0u ? across : own;
    uvec2 ownPixel = uvec2(min(node * BACKGROUND, textureSize(depthCounts, 0) - 1));
    if (chosen.x == 0u) chosen = uvec4(counts.y, ownPixel, 0u);
    if (own.w == 0u) chosen.yz = ownPixel;
    imageStore(samples, node, chosen);
}
