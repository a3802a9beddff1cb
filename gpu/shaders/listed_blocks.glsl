// A work group of 8 x 8 a listed block; twin of gpu::BlockList.
layout(std430, binding = 6) readonly buffer ListedBlocks {
    uint groups, groupsY, groupsZ, blocksAcross; // of glDispatchComputeIndirect; -
    uint blocks[];
};

ivec2 listedBlock() {
    int number = int(blocks[gl_WorkGroupID.x]), across = int(blocksAcross);
    return ivec2(number % across, number / across);
}
ivec2 listedTexel() { return listedBlock() * 8 + ivec2(gl_LocalInvocationID.xy); }
