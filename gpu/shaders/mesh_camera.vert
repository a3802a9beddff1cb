#version 450 core
// A mesh layer as the colour camera would see it from a place moved by `offset` along its axes:
// same intrinsics, same size, distortion included.
#include "mesh_block.glsl"
#include "camera.glsl"
#include "views_block.glsl"

layout(std140, binding = 3) uniform EyeBlock {
    vec4 offset; // metres, colour camera's axes
};

layout(binding = 0) uniform sampler2D points;
layout(binding = 1) uniform sampler2D sources;
layout(location = 0) out vec2 source;
out float gl_ClipDistance[1];

void main() {
    ivec2 node = ivec2(gl_VertexID % tiles.w, gl_VertexID / tiles.w);
    vec4 point = texelFetch(points, node, 0);
    source = texelFetch(sources, node, 0).xy;
    vec3 moved = vec3(rayFromPanel(point.xy), 1.0) * point.w - offset.xyz;
    float z = max(moved.z, range.x);
    vec2 ray = moved.xy / z;
    // Outside the model's valid radius the picture has no meaning: cut there.
    gl_ClipDistance[0] = moved.z > range.x ? colorSize.z - dot(ray, ray) : -1.0;
    vec2 pixel = distortRay(ray, colorRadial, colorRational) * colorPinhole.xy + colorPinhole.zw;
    // Image rows run down, GL's up.
    vec2 position = (2.0 * textureFromPixel(pixel, colorSize.xy) - 1.0) * vec2(1.0, -1.0);
    float key = range.y + range.z * (1.0 - range.x / z);
    gl_Position = vec4(position * z, key * z, z);
}
