#version 450 core
// The background layer: the scene itself where nothing can be behind it, else the surface that
// claims the texel in the colours around, or what is remembered there; beyond the cut the backdrop.
// What the picture shows without any depth keeps its colour; with no depth anywhere it stands in the
// panel's plane.
#include "mesh_block.glsl"
#include "camera.glsl"
#include "cyclopean_grid.glsl"
#include "listed_blocks.glsl"
#include "background_memory.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0) uniform sampler2D filled;
layout(binding = 1) uniform sampler2D claims;
layout(binding = 2) uniform sampler2D guide;
layout(binding = 3) uniform sampler2D colorImage;
layout(binding = 4) uniform sampler2D spread; // colours, pushed
layout(binding = 7) uniform sampler2D backdrop;
layout(r32f, binding = 0) uniform image2D depth;
layout(rgba8, binding = 1) uniform image2D color;
layout(r8ui, binding = 2) uniform writeonly uimage2D changedDepth;
layout(r8ui, binding = 3) uniform writeonly uimage2D changedColor;

// The backdrop covers the grid, margins included, and is cropped to its shape.
vec3 backdropColor(ivec2 texel) {
    vec2 share = (vec2(texel) + 0.5) / grid.xy - 0.5;
    vec2 shown = framing.zw * (1.0 + 2.0 * grid.zw);
    vec2 picture = vec2(textureSize(backdrop, 0));
    vec2 fit = shown / picture;
    return texture(backdrop, share * fit / max(fit.x, fit.y) + 0.5).rgb;
}

void main() {
    ivec2 texel = listedTexel();
    if (any(greaterThanEqual(texel, imageSize(depth)))) return;
    float z = texelFetch(filled, texel, 0).x;
    float behind = texelFetch(claims, texel, 0).x;
    float inverse = texelFetch(guide, texel, 0).x;
    vec2 source = sourceFromPanel(panelFromTexel(vec2(texel)));
    bool own = isInPicture(source) && (z == 0.0 || behind == 0.0);
    vec3 shown = own ? texture(colorImage, source).rgb : texelFetch(spread, texel, 0).rgb;
    float guessed = inverse > 0.0 ? 1.0 / inverse : law.x;
    if (isRemembered(texel, z)) {
        behind = texelFetch(memoryDepth, texel, 0).x;
        shown = texelFetch(memoryColor, texel, 0).rgb;
    }
    float standing = orBackdrop(behind > 0.0 ? behind : z > 0.0 ? z : guessed);
    if (isBackdrop(standing)) shown = backdropColor(texel);
    if (imageLoad(depth, texel).x != standing) {
        imageStore(depth, texel, vec4(standing));
        imageStore(changedDepth, listedBlock(), uvec4(1u));
    }
    vec3 levels = round(shown * 255.0);
    if (round(imageLoad(color, texel).rgb * 255.0) == levels) return;
    imageStore(color, texel, vec4(levels / 255.0, 1.0));
    imageStore(changedColor, listedBlock(), uvec4(1u));
}
