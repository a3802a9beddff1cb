#version 450 core
// A mesh layer as an eye anywhere in front of the panel sees it, on the panel's own pixels: the
// point behind (u, v, d) in display space, projected from the eye onto the panel.
#include "views_block.glsl"

layout(std140, binding = 3) uniform EyeBlock {
    vec4 eye;  // x, y, z from the panel's centre; viewing distance D, all in panel widths
    vec4 form; // Bx (panel widths), panel height in panel widths
};

layout(binding = 0) uniform sampler2D points;
layout(binding = 1) uniform sampler2D sources;
layout(location = 0) out vec2 source;

void main() {
    ivec2 node = ivec2(gl_VertexID % tiles.w, gl_VertexID / tiles.w);
    vec4 point = texelFetch(points, node, 0);
    source = texelFetch(sources, node, 0).xy;
    float z = point.w;
    float height = point.z * eye.w / (form.x + point.z); // from d = Bx Z / (D - Z)
    vec2 cyclopean = (point.xy - 0.5) * vec2(1.0, form.y);
    vec2 place = cyclopean * (eye.w - height) / eye.w;
    // What reaches the eye or lies behind it is drawn as large as can be.
    vec2 seen = eye.xy + (place - eye.xy) * eye.z / max(eye.z - height, 0.02 * eye.z);
    float key = range.y + range.z * (1.0 - range.x / max(z, range.x));
    gl_Position = vec4(2.0 * seen / vec2(1.0, form.y) * z, key * z, z);
}
