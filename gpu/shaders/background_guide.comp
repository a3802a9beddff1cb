#version 450 core
// Seeds of the guide: inverse depth behind claimed texels, with a weight; nothing elsewhere.
layout(local_size_x = 16, local_size_y = 16) in;

layout(binding = 0) uniform sampler2D claims;
layout(rgba32f, binding = 0) uniform writeonly image2D seeds;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, imageSize(seeds)))) return;
    float z = texelFetch(claims, texel, 0).x;
    imageStore(seeds, texel, z > 0.0 ? vec4(1.0 / z, 0.0, 0.0, 1.0) : vec4(0.0));
}
