#version 450 core
// The background layer: the scene itself where nothing can be behind it, else the surface that
// claims the texel in the colours around; depth without any claim is the guide's.
#include "mesh_block.glsl"
#include "camera.glsl"
#include "cyclopean_grid.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

layout(binding = 0) uniform sampler2D filled;
layout(binding = 1) uniform sampler2D claims;
layout(binding = 2) uniform sampler2D guide;
layout(binding = 3) uniform sampler2D colorImage;
layout(binding = 4) uniform sampler2D spread; // colours, pushed
layout(r32f, binding = 0) uniform writeonly image2D depth;
layout(rgba8, binding = 1) uniform writeonly image2D color;

const float kFarM = 100.0; // where nothing was measured at all

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, imageSize(depth)))) return;
    float z = texelFetch(filled, texel, 0).x;
    float behind = texelFetch(claims, texel, 0).x;
    float inverse = texelFetch(guide, texel, 0).x;
    vec3 shown = texelFetch(spread, texel, 0).rgb;
    if (behind > 0.0) {
        z = behind;
    } else if (z > 0.0) {
        shown = texture(colorImage, sourceFromPanel(panelFromTexel(vec2(texel)))).rgb;
    } else {
        z = inverse > 0.0 ? 1.0 / inverse : kFarM;
    }
    imageStore(depth, texel, vec4(z));
    imageStore(color, texel, vec4(shown, 1.0));
}
