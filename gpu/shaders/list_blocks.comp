#version 450 core
// Lists the blocks that are within reach of a mark; twin of gpu::BlockLister.
layout(local_size_x = 64) in;

layout(binding = 0) uniform usampler2D marks[7];
layout(binding = 7) uniform usampler2D among;

layout(std140, binding = 7) uniform ListBlock {
    ivec4 reach[7]; // blocks across, down; 1: along its own rows and columns; Size
    ivec4 size;     // blocks across, down; 1: only those marked in `among`
};
layout(std430, binding = 6) buffer ListedBlocks {
    uint groups, groupsY, groupsZ, blocksAcross;
    uint blocks[];
};

#define STRIP(i, sides)                                                                            \
    {                                                                                              \
        ivec2 last = textureSize(marks[i], 0) - 1;                                                 \
        ivec2 low = clamp(first - (sides), ivec2(0), last), high = min(past + (sides), last);      \
        for (int y = low.y; y <= high.y && found == 0u; ++y)                                       \
            for (int x = low.x; x <= high.x && found == 0u; ++x)                                   \
                found |= texelFetch(marks[i], ivec2(x, y), 0).x;                                   \
    }
#define WALK(i, way, most)                                                                         \
    for (int n = 1; n <= (most) && found == 0u; ++n) {                                             \
        ivec2 at = block + n * way;                                                                \
        if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, size.xy))) break;              \
        found |= texelFetch(marks[i], at, 0).x;                                                    \
        if (texelFetch(among, at, 0).x == 0u) break;                                               \
    }
// Of a picture as large, twice as large (read from half a block before to half a block after its
// own), or half as large (filtered).
#define FIND(i)                                                                                    \
    if (reach[i].w != 0) {                                                                         \
        ivec2 first = block, past = block;                                                         \
        if (reach[i].w == 2) first = 2 * block - 1, past = 2 * block + 2;                          \
        if (reach[i].w == 3) first = (8 * block - 2) / 16, past = (8 * block + 9) / 16;            \
        STRIP(i, reach[i].z == 0 ? reach[i].xy : ivec2(0))                                         \
        ivec2 most = reach[i].xy * reach[i].z;                                                     \
        WALK(i, ivec2(1, 0), most.x)                                                               \
        WALK(i, ivec2(-1, 0), most.x)                                                              \
        WALK(i, ivec2(0, 1), most.y)                                                               \
        WALK(i, ivec2(0, -1), most.y)                                                              \
    }

void main() {
    int number = int(gl_GlobalInvocationID.x);
    if (number >= size.x * size.y) return;
    ivec2 block = ivec2(number % size.x, number / size.x);
    uint found = 0u;
    FIND(0)
    FIND(1)
    FIND(2)
    FIND(3)
    FIND(4)
    FIND(5)
    FIND(6)
    if (size.z != 0 && texelFetch(among, block, 0).x == 0u) found = 0u;
    if (found != 0u) blocks[atomicAdd(groups, 1u)] = uint(number);
}
