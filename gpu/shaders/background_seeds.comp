#version 450 core
// Colours that the hidden background may be continued from: unclaimed and no nearer than what is
// hidden there. Where depth was guessed close beside a nearer surface the colour may be that one's.
// And what is remembered of what is hidden. From afar the farther surfaces speak: what is hidden goes
// on behind a near thing, not from it.
#include "mesh_block.glsl"
#include "camera.glsl"
#include "cyclopean_grid.glsl"
#include "listed_blocks.glsl"
#include "background_memory.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0) uniform sampler2D measured;
layout(binding = 4) uniform sampler2D filled;
layout(binding = 1) uniform sampler2D claims;
layout(binding = 2) uniform sampler2D guide; // 1/m
layout(binding = 3) uniform sampler2D colorImage;
layout(binding = 7) uniform sampler2D guideMean; // 1/m, one texel
layout(rgba32f, binding = 0) uniform image2D seeds;
layout(r8ui, binding = 1) uniform writeonly uimage2D changed;

layout(std140, binding = 3) uniform FillBlock {
    ivec4 reach; // .z: texels beside an edge
};

const float kFarness = 20.0;
const float kLeastWeight = 0.02; // a near surface still speaks close to itself

float weightAt(float z) {
    return clamp(pow(z * texelFetch(guideMean, ivec2(0), 0).x, kFarness), kLeastWeight, 1.0);
}

bool isBesideNearer(ivec2 texel, float z) {
    ivec2 size = textureSize(filled, 0);
    for (int i = 0; i < 4; ++i) {
        ivec2 direction = ivec2((i & 1) * 2 - 1, 0);
        if (i > 1) direction = direction.yx;
        for (int step = 1; step <= reach.z; ++step) {
            ivec2 place = clamp(texel + direction * step, ivec2(0), size - 1);
            float other = texelFetch(filled, place, 0).x;
            if (other > 0.0 && isBehind(z, other)) return true;
        }
    }
    return false;
}

void main() {
    ivec2 texel = listedTexel();
    if (any(greaterThanEqual(texel, imageSize(seeds)))) return;
    vec2 source = sourceFromPanel(panelFromTexel(vec2(texel)));
    float z = texelFetch(filled, texel, 0).x;
    bool guessed = texelFetch(measured, texel, 0).x == 0.0;
    float inverse = texelFetch(guide, texel, 0).x;
    bool far = z > 0.0 && !(inverse > 0.0 && isBehind(1.0 / inverse, z));
    bool known = far && texelFetch(claims, texel, 0).x == 0.0 && isInPicture(source);
    known = known && !isBackdrop(z) && !(guessed && isBesideNearer(texel, z));
    vec4 seed = known ? vec4(texture(colorImage, source).rgb, 1.0) * weightAt(z) : vec4(0.0);
    if (isRemembered(texel, z)) seed = vec4(texelFetch(memoryColor, texel, 0).rgb, 1.0);
    if (imageLoad(seeds, texel) == seed) return;
    imageStore(seeds, texel, seed);
    imageStore(changed, listedBlock(), uvec4(1u));
}
