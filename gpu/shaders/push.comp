#version 450 core
// Back to the finer level: what lacks weight there comes from the level below, between whose texels
// it lies. Result not premultiplied.
layout(local_size_x = 16, local_size_y = 16) in;

layout(binding = 0) uniform sampler2D coarse; // pushed already, linear filter
layout(rgba32f, binding = 0) uniform image2D fine;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(fine);
    if (any(greaterThanEqual(texel, size))) return;
    vec4 own = imageLoad(fine, texel);
#ifdef COARSEST
    imageStore(fine, texel, own.a > 0.0 ? vec4(own.rgb / own.a, 1.0) : vec4(0.0));
#else
    vec2 place = (vec2(texel) + 0.5) / (2.0 * vec2(textureSize(coarse, 0)));
    imageStore(fine, texel, own + (1.0 - own.a) * texture(coarse, place));
#endif
}
