#version 450 core
// Lists the panel's tiles in which any sub-pixel's ray may have come upon something that changed, and
// those in which it may show another colour.
#include "interleaver_block.glsl"
#include "mesh_block.glsl"
#include "layer_search.glsl"
#include "stale_tiles.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

layout(binding = 0) uniform usampler2D changed;       // scene's rows, then the background's
layout(binding = 1) uniform usampler2D changedBlocks; // both together, 8 x 8 texels
layout(binding = 2) uniform usampler2D colorBlocks;   // the same of colours; one texel: of all

layout(std430, binding = 1) buffer Counters { uint searched, recolored; };
layout(std430, binding = 2) buffer StaleTiles {
    TileList search;
    uint staleTiles[];
};
layout(std430, binding = 3) buffer ColorTiles {
    TileList recolor;
    uint colorTiles[];
};

// Column and row of the grid, in texels; not clamped.
vec2 texelAt(vec2 uv) {
    vec2 spread = 1.0 + 2.0 * grid.zw;
    return (vec2(uv.x, 1.0 - uv.y) + grid.zw) / spread * grid.xy;
}

uint anyBlock(ivec2 from, ivec2 to) {
    uint found = 0u;
    for (int y = from.y / 8; y <= to.y / 8 && found == 0u; ++y)
        for (int x = from.x / 8; x <= to.x / 8 && found == 0u; ++x)
            found = texelFetch(changedBlocks, ivec2(x, y), 0).x;
    return found;
}

uint anyChange(ivec2 from, ivec2 to) {
    uint found = 0u;
    if (anyBlock(from, to) == 0u) to.y = from.y - 1;
    for (int y = from.y; y <= to.y && found == 0u; ++y)
        for (int x = from.x / kBlock; x <= to.x / kBlock && found == 0u; ++x)
            found = texelFetch(changed, ivec2(x, y), 0).x |
                    texelFetch(changed, ivec2(x, y + int(grid.y)), 0).x;
    return found;
}

// Colours are filtered: a texel more each way.
uint anyColor(ivec2 from, ivec2 to) {
    ivec2 last = textureSize(colorBlocks, 0) - 1;
    from = min(max(from - 1, ivec2(0)) / 8, last);
    to = min((to + 1) / 8, last);
    uint found = 0u;
    for (int y = from.y; y <= to.y && found == 0u; ++y)
        for (int x = from.x; x <= to.x && found == 0u; ++x)
            found = texelFetch(colorBlocks, ivec2(x, y), 0).x;
    return found;
}

void main() {
    ivec2 tile = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(tile * kTile, panel.xy))) return;
    vec2 first = vec2(tile * kTile), past = min(first + kTile, vec2(panel.xy));
    // With the red and the blue sub-pixel beside the outermost pixels' centres.
    vec2 low = vec2(first.x * fine.x - abs(fine.z), first.y * fine.y);
    vec2 high = vec2(past.x * fine.x + abs(fine.z), past.y * fine.y);
#ifdef UPSIDE_DOWN
    vec2 upper = texelAt(vec2(low.x, 1.0 - low.y)), lower = texelAt(vec2(high.x, 1.0 - high.y));
#else
    vec2 upper = texelAt(vec2(low.x, high.y)), lower = texelAt(vec2(high.x, low.y));
#endif
    // Eyes are within [-1, 1], walks a texel longer than the budget (first_hit.glsl).
    vec2 reach = vec2(max(abs(budget.x), abs(budget.y)) * grid.x / (1.0 + 2.0 * grid.z) + 2.0, 0.0);
    vec2 top = min(upper, lower) - reach - 1e-2, bottom = max(upper, lower) + reach + 1e-2;
    ivec2 last = ivec2(grid.xy) - 1;
    ivec2 from = clamp(ivec2(floor(top)), ivec2(0), last);
    ivec2 to = clamp(ivec2(floor(bottom)), ivec2(0), last);
    uint number = uint(tile.y * tilesAcross(panel.x) + tile.x);
    bool isSearched = anyChange(from, to) != 0u;
    if (isSearched) {
        staleTiles[atomicAdd(search.tiles, 1u)] = number;
        atomicAdd(searched, 1u);
    }
    if (!isSearched && anyColor(from, to) == 0u) return;
    colorTiles[atomicAdd(recolor.tiles, 1u)] = number;
    atomicAdd(recolored, 1u);
}
