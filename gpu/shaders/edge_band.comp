#version 450 core
// Depth edges are only known to about a pixel of the depth camera: takes out what lies that close to
// another surface, so that the colour picture, which is finer, decides there.
#include "mesh_block.glsl"
#include "camera.glsl"
#include "cyclopean_grid.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

layout(binding = 0) uniform sampler2D measured; // m; 0: none
layout(r32f, binding = 0) uniform writeonly image2D sure;

layout(std140, binding = 3) uniform FillBlock {
    ivec4 reach; // .w: half the band's width, texels
};

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(sure);
    if (any(greaterThanEqual(texel, size))) return;
    float z = texelFetch(measured, texel, 0).x;
    float nearest = z, farthest = z;
    for (int y = -reach.w; y <= reach.w && z > 0.0; ++y) {
        for (int x = -reach.w; x <= reach.w; ++x) {
            ivec2 place = clamp(texel + ivec2(x, y), ivec2(0), size - 1);
            float other = texelFetch(measured, place, 0).x;
            if (other == 0.0) continue;
            nearest = min(nearest, other);
            farthest = max(farthest, other);
        }
    }
    bool beside = isBehind(farthest, z) || isBehind(z, nearest);
    imageStore(sure, texel, vec4(beside ? 0.0 : z));
}
