#version 450 core
// The measured mesh on the grid over the cyclopean view; row 0 of the texture is the top.
#include "mesh_block.glsl"
#include "views_block.glsl"

layout(binding = 0) uniform sampler2D points;
layout(location = 0) out float depth;

void main() {
    vec4 point = texelFetch(points, ivec2(gl_VertexID % tiles.w, gl_VertexID / tiles.w), 0);
    depth = point.w;
    vec2 place = (point.xy + grid.zw) / (1.0 + 2.0 * grid.zw);
    float key = range.y + range.z * (1.0 - range.x / max(depth, range.x));
    gl_Position = vec4(vec2(2.0 * place.x - 1.0, 1.0 - 2.0 * place.y) * depth, key * depth, depth);
}
