#version 450 core
// The background layer: one node a texel, all connected, coloured by its own picture; the outermost
// stand on the grid's edge.
#include "mesh_block.glsl"
#include "camera.glsl"
#include "disparity.glsl"
#include "cyclopean_grid.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

layout(binding = 0) uniform sampler2D depth;
layout(rgba32f, binding = 0) uniform writeonly image2D points; // u, v, disparity, z
layout(rg32f, binding = 1) uniform writeonly image2D sources;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(points);
    if (any(greaterThanEqual(texel, size))) return;
    float z = texelFetch(depth, texel, 0).x;
    vec2 place = vec2(texel) + 0.5 * (vec2(equal(texel, size - 1)) - vec2(equal(texel, ivec2(0))));
    imageStore(points, texel, vec4(panelFromTexel(place), disparityAt(z, law, budget.xy), z));
    imageStore(sources, texel, vec4((vec2(texel) + 0.5) / vec2(size), 0.0, 0.0));
}
