#version 450 core
// A mesh layer as the colour camera itself sees it (its pixels, distortion included).
#include "views_block.glsl"

layout(binding = 0) uniform sampler2D points;
layout(binding = 1) uniform sampler2D sources;
layout(location = 0) out float depth;

void main() {
    ivec2 node = ivec2(gl_VertexID % tiles.w, gl_VertexID / tiles.w);
    depth = texelFetch(points, node, 0).w;
    // Row 0 of the texture is the top of the image, as it is read back.
    vec2 position = 2.0 * texelFetch(sources, node, 0).xy - 1.0;
    float key = range.y + range.z * (1.0 - range.x / max(depth, range.x));
    gl_Position = vec4(position * depth, key * depth, depth);
}
