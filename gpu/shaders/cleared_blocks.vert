#version 450 core
// Listed blocks of the cyclopean grid as points of 8 x 8 texels on the far plane; see
// BlockList::drawPoints.
#include "mesh_block.glsl"

layout(std430, binding = 6) readonly buffer ListedBlocks {
    uint groups, groupsY, groupsZ, blocksAcross;
    uint blocks[];
};
flat out ivec2 block;

void main() {
    int number = int(blocks[gl_VertexID - 1]), across = int(blocksAcross);
    block = ivec2(number % across, number / across);
    vec2 centre = min(vec2(block) * 8.0 + 4.0, grid.xy - 0.5); // or it would be clipped as a whole
    gl_Position = vec4(centre / grid.xy * 2.0 - 1.0, 1.0, 1.0);
    gl_PointSize = 8.0;
}
