#version 450 core
// Lists the panel's tiles in which any sub-pixel's ray may meet anything of a scene.
layout(local_size_x = 16, local_size_y = 16) in;
#include "interleaver_block.glsl"
#include "scene_parts.glsl"
#include "scene_surfaces.glsl"
#include "stale_tiles.glsl"

layout(std430, binding = 2) buffer DrawnTiles {
    TileList drawn;
    uint drawnTiles[]; // row by row from the top left
};

void main() {
    ivec2 tile = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(tile * kTile, panel.xy))) return;
    // With the red and the blue sub-pixel beside the outermost pixels' centres.
    vec2 low = vec2(tile * kTile) * fine.xy, high = low + vec2(kTile) * fine.xy;
#ifdef UPSIDE_DOWN
    float lower = 1.0 - high.y;
    high.y = 1.0 - low.y;
    low.y = lower;
#endif
    low.x -= abs(fine.z);
    high.x += abs(fine.z);
    vec2 texels = vec2(lattice.x - 2 * lattice.y, lattice.z);
    vec2 margin = vec2(lattice.y, 0.0);
    ivec3 last = textureSize(peaks, 0) - 1;
    ivec2 from = ivec2(floor(low * texels + margin)), to = ivec2(floor(high * texels + margin)) + 1;
    from.x /= kPeakBlock;
    to.x /= kPeakBlock;
    from = clamp(from - 1, ivec2(0), last.xy);
    to = clamp(to, ivec2(0), last.xy);
    float nearest = span.y;
    for (int reference = 0; reference <= last.z; ++reference)
        for (int y = from.y; y <= to.y; ++y)
            for (int x = from.x; x <= to.x; ++x)
                nearest = max(nearest, texelFetch(peaks, ivec3(x, y, reference), 0).x);
    if (nearest <= span.y) return;
    drawnTiles[atomicAdd(drawn.tiles, 1u)] = uint(tile.y * tilesAcross(panel.x) + tile.x);
}
