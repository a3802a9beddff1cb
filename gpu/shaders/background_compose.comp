#version 450 core
// The background layer: the scene itself where nothing can be behind it, else the surface that
// claims the texel in the colours around, or what is remembered there. What the picture shows without any depth keeps its colour;
// with no depth anywhere it stands in the panel's plane.
#include "mesh_block.glsl"
#include "camera.glsl"
#include "cyclopean_grid.glsl"
#include "background_memory.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

layout(binding = 0) uniform sampler2D filled;
layout(binding = 1) uniform sampler2D claims;
layout(binding = 2) uniform sampler2D guide;
layout(binding = 3) uniform sampler2D colorImage;
layout(binding = 4) uniform sampler2D spread; // colours, pushed
layout(r32f, binding = 0) uniform writeonly image2D depth;
layout(rgba8, binding = 1) uniform writeonly image2D color;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
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
    imageStore(depth, texel, vec4(behind > 0.0 ? behind : z > 0.0 ? z : guessed));
    imageStore(color, texel, vec4(shown, 1.0));
}
