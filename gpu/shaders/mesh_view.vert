#version 450 core
// A mesh layer seen from position b on the fan: x = u - b d, y unchanged. w = z makes the colour
// coordinate perspective-correct and leaves x linear. TILED: all views in one instanced draw, cut
// to their tiles by clip distances; else one view per draw, cut by the viewport.
#include "views_block.glsl"

layout(binding = 0) uniform sampler2D points;
layout(binding = 1) uniform sampler2D sources;
layout(binding = 3) uniform sampler2D viewPositions; // b of each view, left to right

layout(location = 0) out vec2 source;
#ifdef DISPARITY
layout(location = 1) noperspective out float disparity; // as x: linear on the panel
#endif
#ifdef TILED
out float gl_ClipDistance[4];
#endif

void main() {
    ivec2 node = ivec2(gl_VertexID % tiles.w, gl_VertexID / tiles.w);
    vec4 point = texelFetch(points, node, 0);
    source = texelFetch(sources, node, 0).xy;
    float z = point.w;
#ifdef DISPARITY
    disparity = point.z;
#endif
#ifdef TILED
    int view = gl_InstanceID;
#else
    int view = tiles.z;
#endif
    float b = texelFetch(viewPositions, ivec2(view, 0), 0).x;
    vec2 position = vec2(point.x - b * point.z, point.y);
    float key = range.y + range.z * (1.0 - range.x / max(z, range.x));
#ifdef TILED
    gl_ClipDistance[0] = position.x * z;
    gl_ClipDistance[1] = (1.0 - position.x) * z;
    gl_ClipDistance[2] = position.y * z;
    gl_ClipDistance[3] = (1.0 - position.y) * z;
    position = (position + vec2(view % tiles.x, view / tiles.x)) / vec2(tiles.xy);
#endif
    gl_Position = vec4((2.0 * position - 1.0) * z, key * z, z);
}
