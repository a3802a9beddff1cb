#version 450 core
// Blocks of the grid that show a marked block of the colour camera's picture. BOUNDS: first, for each
// block of the grid, which blocks of the picture it shows.
#include "mesh_block.glsl"
#include "camera.glsl"
#include "cyclopean_grid.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

#ifdef BOUNDS
layout(rgba16ui, binding = 0) uniform writeonly uimage2D bounds; // first, last; in blocks

const float kFilter = 2.0; // pixels: bilinear weights, and what bends between two corners

void main() {
    ivec2 block = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(block, imageSize(bounds)))) return;
    vec2 low = vec2(1e9), high = vec2(-1e9);
    for (int y = -2; y <= 9; ++y) { // a texel beside its own, at both its ends
        for (int x = -2; x <= 9; ++x) {
            vec2 source = sourceFromPanel(panelFromTexel(vec2(8 * block + ivec2(x, y)) + 0.5));
            if (source == kNoSource) continue;
            low = min(low, source * colorSize.xy);
            high = max(high, source * colorSize.xy);
        }
    }
    uvec4 shown = uvec4(1u, 1u, 0u, 0u); // nothing
    vec2 last = colorSize.xy - 1.0;
    if (low.x <= high.x)
        shown = uvec4(clamp(low - kFilter, vec2(0.0), last), clamp(high + kFilter, vec2(0.0), last)) / 8u;
    imageStore(bounds, block, shown);
}
#else
layout(binding = 0) uniform usampler2D bounds;
layout(binding = 1) uniform usampler2D picture;
layout(r8ui, binding = 0) uniform writeonly uimage2D shown;
layout(r8ui, binding = 1) uniform writeonly uimage2D shownToo;

void main() {
    ivec2 block = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(block, imageSize(shown)))) return;
    ivec4 place = ivec4(texelFetch(bounds, block, 0));
    uint found = 0u;
    for (int y = place.y; y <= place.w && found == 0u; ++y)
        for (int x = place.x; x <= place.z && found == 0u; ++x)
            found = texelFetch(picture, ivec2(x, y), 0).x;
    if (found == 0u) return;
    imageStore(shown, block, uvec4(1u));
    imageStore(shownToo, block, uvec4(1u));
}
#endif
