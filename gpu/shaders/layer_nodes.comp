#version 450 core
// The background layer: a node at each corner of the grid's texels, all connected, coloured by its
// own picture.
#include "mesh_block.glsl"
#include "camera.glsl"
#include "disparity.glsl"
#include "cyclopean_grid.glsl"
#include "layer_corner.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

layout(binding = 0) uniform sampler2D depth;
layout(rgba32f, binding = 0) uniform writeonly image2D points; // u, v, disparity, z
layout(rg32f, binding = 1) uniform writeonly image2D sources;

void main() {
    ivec2 node = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(node, imageSize(points)))) return;
    Corner corner = cornerOf(depth, node, 0.0, true);
    vec2 uv = panelFromTexel(vec2(node) - 0.5);
    imageStore(points, node, vec4(uv, corner.disparity, corner.z));
    imageStore(sources, node, vec4(vec2(node) / vec2(imageSize(points) - 1), 0.0, 0.0));
}
