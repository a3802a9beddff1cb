#version 450 core
// Both layers for the search: disparity at the corners of each texel's quad, scene above, background
// below it; and which blocks are not as they were.
#include "mesh_block.glsl"
#include "camera.glsl"
#include "disparity.glsl"
#include "cyclopean_grid.glsl"
#include "layer_corner.glsl"
#include "layer_search.glsl"
#include "listed_blocks.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0) uniform sampler2D filled;
layout(binding = 1) uniform sampler2D background;
layout(rgba32f, binding = 0) uniform image2D quads; // top left, right, bottom left, right
layout(r8ui, binding = 1) uniform writeonly uimage2D changed;
layout(r8ui, binding = 2) uniform writeonly uimage2D changedBlocks;

vec4 sceneCorners(ivec2 texel, float own) {
    if (own == 0.0 || isBackdrop(own)) return vec4(kNoSurface);
    return vec4(cornerOf(filled, texel, own, false).disparity,
                cornerOf(filled, texel + ivec2(1, 0), own, false).disparity,
                cornerOf(filled, texel + ivec2(0, 1), own, false).disparity,
                cornerOf(filled, texel + 1, own, false).disparity);
}

vec4 backgroundCorners(ivec2 texel) {
    return vec4(cornerOf(background, texel, 0.0, true).disparity,
                cornerOf(background, texel + ivec2(1, 0), 0.0, true).disparity,
                cornerOf(background, texel + ivec2(0, 1), 0.0, true).disparity,
                cornerOf(background, texel + 1, 0.0, true).disparity);
}

void keep(ivec2 place, vec4 corners) {
    if (imageLoad(quads, place) == corners) return;
    imageStore(quads, place, corners);
    imageStore(changed, ivec2(place.x / kBlock, place.y), uvec4(1u));
    imageStore(changedBlocks, listedBlock(), uvec4(1u));
}

void main() {
    ivec2 texel = listedTexel();
    ivec2 size = textureSize(filled, 0);
    if (any(greaterThanEqual(texel, size))) return;
    keep(texel, sceneCorners(texel, texelFetch(filled, texel, 0).x));
    keep(texel + ivec2(0, size.y), backgroundCorners(texel));
}
