#version 450 core
// Keys of the registration -> metres; 0 where nothing was drawn.
#include "registered_keys.glsl"

layout(binding = 0) uniform usampler2D keys;
layout(location = 0) out float metres;

void main() { metres = depthOf(texelFetch(keys, ivec2(gl_FragCoord.xy), 0).x); }
