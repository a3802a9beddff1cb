#version 450 core
// Depth edges are only known to about a pixel of the depth camera: takes out what lies that close to
// another surface, so that the colour picture, which is finer, decides there.
#include "mesh_block.glsl"
#include "camera.glsl"
#include "cyclopean_grid.glsl"
#include "listed_blocks.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0) uniform sampler2D measured; // m; 0: none
layout(r32f, binding = 0) uniform image2D sure;
layout(r8ui, binding = 1) uniform writeonly uimage2D changed;
layout(r8ui, binding = 2) uniform writeonly uimage2D unsure; // blocks for fill_holes.comp

layout(std140, binding = 3) uniform FillBlock {
    ivec4 reach; // .w: half the band's width, texels
};

void main() {
    ivec2 texel = listedTexel();
    ivec2 size = imageSize(sure);
    if (any(greaterThanEqual(texel, size))) return;
    float z = texelFetch(measured, texel, 0).x;
    float nearest = z, farthest = z;
    for (int y = -reach.w; y <= reach.w && z > 0.0; ++y) {
        for (int x = -reach.w; x <= reach.w; ++x) {
            ivec2 place = clamp(texel + ivec2(x, y), ivec2(0), size - 1);
            float other = texelFetch(measured, place, 0).x;
            if (other == 0.0) continue;
            nearest = min(nearest, other);
            farthest = max(farthest, other);
        }
    }
    bool beside = isBehind(farthest, z) || isBehind(z, nearest);
    float kept = beside ? 0.0 : z;
    bool isNew = imageLoad(sure, texel).x != kept;
    if (isNew) {
        imageStore(sure, texel, vec4(kept));
        imageStore(changed, listedBlock(), uvec4(1u));
    }
    if (isNew || kept == 0.0) imageStore(unsure, listedBlock(), uvec4(1u));
}
