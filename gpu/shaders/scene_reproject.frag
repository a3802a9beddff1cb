#version 450 core
// Every view's tile: where its pixels are found in the reference viewpoints (the super-multi-view
// paper, section II B, first step), from one reference to the next where one has a hole.
#include "scene_block.glsl"
#include "scene_parts.glsl"
#include "scene_surfaces.glsl"
#include "scene_search.glsl"
#include "scene_root.glsl"
#include "scene_tile.glsl"
layout(binding = 10) uniform sampler2D viewPositions; // b of each view, left to right

layout(location = 0) out uint root;

void main() {
    TilePixel pixel = tilePixel();
    float b = texelFetch(viewPositions, ivec2(max(pixel.view, 0), 0), 0).x;
    Found found = searchReferences(float(pixel.inside.x) + 0.5, b, pixel.inside.y);
    int column = int(floor(found.x));
    bool isNothing = disparityAt(found.reference, column, pixel.inside.y) <= span.y;
    isNothing = pixel.view < 0 || (isNothing && !found.isGap);
    root = isNothing ? kNothing : found.isGap ? kHole : rootOf(found.reference, found.x);
    gl_FragDepth = isNothing ? 0.0 : 1.0; // scene_resolve.frag, at 0.5, leaves nothing alone
}
