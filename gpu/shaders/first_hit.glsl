// The surface of a layer that a ray (x, b) meets first. In texels of the grid: on the ray u = x +
// reach d, so that walking from x + reach d_max to x + reach d_min is walking away from the eye; h =
// +-(u - x) - |reach| d(u) is how far the ray is still in front. Along a row a quad is two linear
// pieces, its diagonal between them, so the root is exact. A jump between quads is no hit.
// Needs mesh_block.glsl, layer_search.glsl.
layout(binding = 0) uniform sampler2D quads;
layout(binding = 7) uniform sampler2D tops;

const float kMiss = -1.0;
const float kLeastReach = 1e-6; // so that texels without depth are behind every ray

struct Walk {
    float x, spread, way; // way: +1 leftwards (an eye to the right), -1 rightwards
    bool leftwards;
    int step;
};

float inFront(Walk walk, float u, float disparity) {
    return walk.way * (u - walk.x) - walk.spread * disparity;
}

// First block, from `block` on, with something that the ray may meet.
int skipBlocks(int row, Walk walk, int block, int last) {
    for (int left = textureSize(tops, 0).x; left > 0; --left) {
        float exit = float((walk.leftwards ? block : block + 1) * kBlock);
        float top = texelFetch(tops, ivec2(block, row), 0).x;
        if (inFront(walk, exit, top) <= 0.0 || block == last) break;
        block += walk.step;
    }
    return block;
}

float walkCells(int row, float down, Walk walk, int cell, int last) {
    float hit = kMiss;
    for (int left = textureSize(quads, 0).x; left > 0; --left) {
        vec4 quad = texelFetch(quads, ivec2(cell, row), 0);
        vec2 sides = mix(quad.xy, quad.zw, down); // left, right
        float here = float(cell);
        float entryAt = walk.leftwards ? here + 1.0 : here, exitAt = walk.leftwards ? here : here + 1.0;
        float middleAt = here + 1.0 - down;
        float entry = inFront(walk, entryAt, walk.leftwards ? sides.y : sides.x);
        float middle = inFront(walk, middleAt, mix(quad.y, quad.z, down));
        float exit = inFront(walk, exitAt, walk.leftwards ? sides.x : sides.y);
        bool first = entry > 0.0 && middle <= 0.0;
        if (first || (middle > 0.0 && exit <= 0.0)) {
            float from = first ? entryAt : middleAt, to = first ? middleAt : exitAt;
            float above = first ? entry : middle, below = first ? middle : exit;
            hit = from + (to - from) * (above / (above - below));
            break;
        }
        if (cell == last) break;
        cell += walk.step;
    }
    return hit;
}

// A row of the grid, and what a walk along it needs of the uniforms.
struct Row {
    int scene, perLayer; // its number; rows from a layer to the next
    int lastColumn;
    float down;          // the share of it above the ray
    float farthest, nearest; // disparity
};

// Texels from the grid's left edge, or kMiss; of layer 0, the scene, or 1, the background, which
// nothing misses.
float firstHit(Row row, int layer, float x, float reach) {
    int number = row.scene + layer * row.perLayer;
    bool leftwards = reach >= 0.0;
    Walk walk = Walk(x, max(abs(reach), kLeastReach), leftwards ? 1.0 : -1.0, leftwards,
                     leftwards ? -1 : 1);
    // One texel more than needed at either end: rounding must not begin the walk behind the nearest
    // surface, nor end it in front of the farthest.
    int cell = clamp(int(floor(x + reach * row.nearest)) - walk.step, 0, row.lastColumn);
    int last = clamp(int(floor(x + reach * row.farthest)) + walk.step, 0, row.lastColumn);
    int block = skipBlocks(number, walk, cell / kBlock, last / kBlock);
    // Into the block, where it begins farther on.
    cell = leftwards ? min(cell, block * kBlock + kBlock - 1) : max(cell, block * kBlock);
    float hit = walkCells(number, row.down, walk, cell, last);
    return hit < 0.0 && layer == 1 ? x + reach * row.farthest : hit;
}
