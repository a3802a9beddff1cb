#version 450 core
// Takes out the nodes that the colour camera cannot see: a surface nearer by more than the cut
// stands in its line of sight, so the colour found there belongs to that surface.
#include "mesh_block.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

layout(binding = 0) uniform sampler2D registered; // nearest depth at the colour camera, m; 0: none
layout(binding = 1) uniform sampler2D sources;
layout(rgba32f, binding = 0) uniform image2D points;

void main() {
    ivec2 node = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(node, imageSize(points)))) return;
    vec4 point = imageLoad(points, node);
    vec2 size = vec2(textureSize(registered, 0));
    ivec2 texel = ivec2(floor(texelFetch(sources, node, 0).xy * size));
    if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, ivec2(size)))) return;
    float nearest = texelFetch(registered, texel, 0).x;
    if (nearest > 0.0 && point.w > nearest * (1.0 + float(counts.z) * 0.001))
        imageStore(points, node, vec4(0.0));
}
