#version 450 core
// CUBIC: for pictures drawn once, sharper than the filter of the hardware (Keys 1981, a = -1/2).
layout(binding = 2) uniform sampler2D colorImage;
layout(location = 0) in vec2 source;
layout(location = 0) out vec4 color;

#ifdef CUBIC
vec4 keys(float t) {
    vec4 x = vec4(1.0 + t, t, 1.0 - t, 2.0 - t);
    vec4 inner = (1.5 * x - 2.5) * x * x + 1.0;
    vec4 outer = ((-0.5 * x + 2.5) * x - 4.0) * x + 2.0;
    return vec4(outer.x, inner.yz, outer.w);
}

vec3 sampleColor(vec2 place) {
    vec2 texel = place * vec2(textureSize(colorImage, 0)) - 0.5;
    ivec2 first = ivec2(floor(texel)) - 1, last = textureSize(colorImage, 0) - 1;
    vec4 across = keys(fract(texel.x)), along = keys(fract(texel.y));
    vec3 sum = vec3(0.0);
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i)
            sum += across[i] * along[j] *
                   texelFetch(colorImage, clamp(first + ivec2(i, j), ivec2(0), last), 0).rgb;
    return sum;
}
#else
vec3 sampleColor(vec2 place) { return texture(colorImage, place).rgb; }
#endif

void main() { color = vec4(sampleColor(source), 1.0); }
