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
    if (pixel.view < 0) discard;
    float b = texelFetch(viewPositions, ivec2(pixel.view, 0), 0).x;
    Found found = searchReferences(float(pixel.inside.x) + 0.5, b, pixel.inside.y);
    int column = int(floor(found.x));
    bool isNothing = disparityAt(found.reference, column, pixel.inside.y) <= span.y;
    root = found.isGap ? kHole : isNothing ? kNothing : rootOf(found.reference, found.x);
}
