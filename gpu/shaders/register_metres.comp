#version 450 core
// Keys of the registration -> metres; 0 where nothing was drawn.
#include "registered_keys.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

layout(r32ui, binding = 0) uniform readonly uimage2D keys;
layout(r32f, binding = 1) uniform writeonly image2D metres;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(metres)))) return;
    imageStore(metres, pixel, vec4(depthOf(imageLoad(keys, pixel).x)));
}
