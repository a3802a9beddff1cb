#version 450 core
// Half the size: weighted means, premultiplied (alpha is the weight); binomial 1 3 3 1 each way.
// SHARP: a fifth of the weight is enough to keep to what lies this close.
layout(local_size_x = 16, local_size_y = 16) in;

layout(binding = 0) uniform sampler2D fine;
layout(rgba32f, binding = 0) uniform writeonly image2D coarse;

const float kWeights[4] = float[4](0.125, 0.375, 0.375, 0.125);

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
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
    imageStore(coarse, texel, sum);
}
