// calib::GridTables: bilinear between nodes, in whole numbers.
#ifdef GRID
layout(binding = 3) uniform usampler2D gridNodes;
layout(binding = 4) uniform usampler2D gridColumns; // node, weight in 2^-31
layout(binding = 5) uniform usampler2D gridRows;

uint between(uint a, uint b, uint weight) {
    int high, low;
    imulExtended(int(b - a), int(weight), high, low);
    return a + ((uint(high) << 1) | (uint(low) >> 31));
}

// Of a pixel from the top left.
uint gridPhase(ivec2 place) {
    uvec2 across = texelFetch(gridColumns, ivec2(place.x, 0), 0).xy;
    uvec2 down = texelFetch(gridRows, ivec2(place.y, 0), 0).xy;
    ivec2 first = ivec2(across.x, down.x);
    ivec2 next = min(first + 1, textureSize(gridNodes, 0) - 1);
    uint upper = between(texelFetch(gridNodes, first, 0).x,
                         texelFetch(gridNodes, ivec2(next.x, first.y), 0).x, across.y);
    uint lower = between(texelFetch(gridNodes, ivec2(first.x, next.y), 0).x,
                         texelFetch(gridNodes, next, 0).x, across.y);
    return between(upper, lower, down.y);
}
#else
uint gridPhase(ivec2 place) { return 0u; }
#endif
