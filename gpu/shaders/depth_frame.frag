#version 450 core
// 2D-plus-depth frame: the picture in the left half, its disparity as grey in the right half, the
// header's bits in the blue of the top row.
#include "interleaver_block.glsl"
#include "tile_samples.glsl"

layout(binding = 1) uniform sampler2D disparity; // panel widths at |b| = 1, in the tile's own size
#ifdef HEADER
layout(binding = 2) uniform usampler2D header; // blue level per pixel of the top row
#endif

layout(location = 0) out vec4 color;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy); // y up
    int half_ = panel.x / 2;
    bool right = pixel.x >= half_;
    vec2 inside = vec2(right ? pixel.x - half_ : pixel.x, pixel.y) + 0.5;
    vec2 texel = inside * vec2(tiles.yz) / vec2(half_, panel.y);
    if (right) {
        // Depth is not blended across edges: in between there is nothing.
        float d = texelFetch(disparity, clamp(ivec2(texel), ivec2(0), tiles.yz - 1), 0).x;
        color = vec4(vec3((edge.z + edge.w * d) / 255.0), 1.0);
    } else {
        color = vec4(sampleView(0, texel, 0), sampleView(0, texel, 1), sampleView(0, texel, 2), 1.0);
    }
#ifdef HEADER
    if (pixel.y == panel.y - 1 && pixel.x < textureSize(header, 0).x)
        color.b = float(texelFetch(header, ivec2(pixel.x, 0), 0).x) / 255.0;
#endif
}
