#version 450 core
// Back to the finer level: what lacks weight there comes from the level below, between whose texels
// it lies. Result not premultiplied, in steps of 2^-12, so that what changes far off changes nothing.
// Of the finest level, GUIDE and HIDDEN mark only where the value counts: as a guide where it decides
// otherwise or stands for itself, as a colour where something is hidden.
#include "listed_blocks.glsl"
#ifdef GUIDE
#include "mesh_block.glsl"
#include "camera.glsl"
#include "cyclopean_grid.glsl"
#endif

layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0) uniform sampler2D coarse; // pushed already, linear filter
layout(binding = 1) uniform sampler2D pulled;
layout(rgba32f, binding = 0) uniform image2D pushed;
layout(r8ui, binding = 1) uniform writeonly uimage2D changed;

#if defined(GUIDE) || defined(HIDDEN)
layout(binding = 2) uniform sampler2D filled;
layout(binding = 3) uniform sampler2D claims;
#endif

bool matters(ivec2 texel, float before, float now) {
#if defined(GUIDE)
    float z = texelFetch(filled, texel, 0).x;
    if (z == 0.0) return texelFetch(claims, texel, 0).x == 0.0;
    bool wasNearer = before > 0.0 && isBehind(1.0 / before, z);
    return wasNearer != (now > 0.0 && isBehind(1.0 / now, z)); // as background_seeds asks
#elif defined(HIDDEN)
    return texelFetch(filled, texel, 0).x == 0.0 || texelFetch(claims, texel, 0).x > 0.0;
#else
    return true;
#endif
}

void main() {
    ivec2 texel = listedTexel();
    if (any(greaterThanEqual(texel, imageSize(pushed)))) return;
    vec4 own = texelFetch(pulled, texel, 0);
#ifdef COARSEST
    vec4 all = own.a > 0.0 ? vec4(own.rgb / own.a, 1.0) : vec4(0.0);
#else
    vec2 place = (vec2(texel) + 0.5) / (2.0 * vec2(textureSize(coarse, 0)));
    vec4 all = own + (1.0 - own.a) * texture(coarse, place);
#endif
    all = round(all * 4096.0) / 4096.0;
    vec4 before = imageLoad(pushed, texel);
#ifdef HELD
    // Every seed is weighed by it: it stays while it is about right.
    if (all.a == before.a && abs(all.x - before.x) <= 0.02 * before.x) all = before;
#endif
    if (before == all) return;
    imageStore(pushed, texel, all);
    if (matters(texel, before.x, all.x)) imageStore(changed, listedBlock(), uvec4(1u));
}
