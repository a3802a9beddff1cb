// Places and materials of a scene's parts, 11 texels each, 64 to a row; twin of gpu::ScenePart.
#ifndef PARTS_UNIT
#define PARTS_UNIT 1
#endif
layout(binding = PARTS_UNIT) uniform sampler2D partTexels;

const int kTexels = 11, kPerRow = 64;

vec4 partTexel(int part, int texel) {
    return texelFetch(partTexels, ivec2(part % kPerRow * kTexels + texel, part / kPerRow), 0);
}
mat4 toDisplay(int part) {
    return mat4(partTexel(part, 0), partTexel(part, 1), partTexel(part, 2), partTexel(part, 3));
}
mat3 normalsToDisplay(int part) {
    return mat3(partTexel(part, 4).xyz, partTexel(part, 5).xyz, partTexel(part, 6).xyz);
}
vec4 diffuseOf(int part) { return partTexel(part, 8); } // w: shininess
vec3 specularOf(int part) { return partTexel(part, 9).rgb; }
vec3 emissiveOf(int part) { return partTexel(part, 10).rgb; }
