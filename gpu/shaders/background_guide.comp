#version 450 core
// Seeds of the guide: inverse depth behind claimed texels, with a weight; nothing elsewhere.
#include "listed_blocks.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0) uniform sampler2D claims;
layout(rgba32f, binding = 0) uniform image2D seeds;
layout(r8ui, binding = 1) uniform writeonly uimage2D changed;

void main() {
    ivec2 texel = listedTexel();
    if (any(greaterThanEqual(texel, imageSize(seeds)))) return;
    float z = texelFetch(claims, texel, 0).x;
    vec4 seed = z > 0.0 ? vec4(1.0 / z, 0.0, 0.0, 1.0) : vec4(0.0);
    if (imageLoad(seeds, texel) == seed) return;
    imageStore(seeds, texel, seed);
    imageStore(changed, listedBlock(), uvec4(1u));
}
