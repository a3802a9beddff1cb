#version 450 core
// Half the size: weighted means, premultiplied (alpha is the weight); binomial 1 3 3 1 each way.
// SHARP: a fifth of the weight is enough to keep to what lies this close.
#include "listed_blocks.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0) uniform sampler2D fine;
layout(rgba32f, binding = 0) uniform image2D coarse;
layout(r8ui, binding = 1) uniform writeonly uimage2D changed;

const float kWeights[4] = float[4](0.125, 0.375, 0.375, 0.125);

void main() {
    ivec2 texel = listedTexel();
    if (any(greaterThanEqual(texel, imageSize(coarse)))) return;
    ivec2 size = textureSize(fine, 0);
    vec4 sum = vec4(0.0);
    for (int j = 0; j < 4; ++j) {
        for (int i = 0; i < 4; ++i) {
            ivec2 place = 2 * texel + ivec2(i, j) - 1;
            if (any(lessThan(place, ivec2(0))) || any(greaterThanEqual(place, size))) continue;
            sum += kWeights[i] * kWeights[j] * texelFetch(fine, place, 0);
        }
    }
#ifdef SHARP
    if (sum.a > 0.0) sum *= min(1.0 / sum.a, 5.0);
#endif
    if (imageLoad(coarse, texel) == sum) return;
    imageStore(coarse, texel, sum);
    imageStore(changed, listedBlock(), uvec4(1u));
}
