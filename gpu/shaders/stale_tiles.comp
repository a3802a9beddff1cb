#version 450 core
// Lists the panel's squares in which any sub-pixel's ray may have come upon something that changed.
#include "interleaver_block.glsl"
#include "mesh_block.glsl"
#include "layer_search.glsl"
#include "stale_tiles.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

layout(binding = 0) uniform usampler2D stale;

layout(std430, binding = 1) buffer Counters { uint searched; };

// Row and column of the grid, in texels; not clamped.
vec2 texelAt(vec2 uv) {
    vec2 spread = 1.0 + 2.0 * grid.zw;
    return (vec2(uv.x, 1.0 - uv.y) + grid.zw) / spread * grid.xy;
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
    vec2 top = min(upper, lower) - 1e-2, bottom = max(upper, lower) + 1e-2; // beyond rounding
    ivec2 last = textureSize(stale, 0) - 1;
    ivec2 from = clamp(ivec2(floor(vec2(top.x / float(kBlock), top.y))), ivec2(0), last);
    ivec2 to = clamp(ivec2(floor(vec2(bottom.x / float(kBlock), bottom.y))), ivec2(0), last);
    uint found = 0u;
    for (int y = from.y; y <= to.y && found == 0u; ++y)
        for (int x = from.x; x <= to.x && found == 0u; ++x)
            found = texelFetch(stale, ivec2(x, y), 0).x;
    if (found == 0u) return;
    staleSquares[atomicAdd(squares, 1u)] = uint(tile.y * tilesAcross(panel.x) + tile.x);
    atomicAdd(searched, 1u);
}
