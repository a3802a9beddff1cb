#version 450 core
// What stands in place of cut triangles. A depth pixel measures a square, not a point: a triangle
// is shared out among its measured corners, each at its own depth as far as the pixels' common
// border. EXTRUDE: the farthest corner's square, larger on every side by so many pixels, behind all
// that was measured.
#include "mesh_block.glsl"
#include "camera.glsl"
#include "color_camera.glsl"
#include "registered_keys.glsl"
#include "registered_cover.glsl"
#include "registered_nodes.glsl"
#include "cut_triangles.glsl"

#ifdef EXTRUDE
layout(local_size_y = 64) in;

// A corner of the square: the outer edge of the last pixel is half way between it and the next.
vec3 outerCorner(Corner owner, int x, int y) {
    ivec2 last = ivec2(x, y) * int(counts.w);
    return halfWay(owner, owner.node + last, owner.node + last + ivec2(x, y));
}

void drawPart(Corner corners[3]) {
    Corner owner = corners[0];
    if (corners[1].count > owner.count) owner = corners[1];
    if (corners[2].count > owner.count) owner = corners[2];
    cover(outerCorner(owner, -1, -1), outerCorner(owner, 1, -1), outerCorner(owner, -1, 1),
          outerCorner(owner, 1, 1), false);
}
#else
layout(local_size_x = 3, local_size_y = 64) in; // a corner each

// A square at the right angle, else a triangle.
void drawPart(Corner corners[3]) {
    uint which = gl_LocalInvocationID.x;
    Corner owner = corners[which];
    if (owner.count == 0u) return;
    ivec2 next = corners[(which + 1u) % 3u].node, other = corners[(which + 2u) % 3u].node;
    vec3 a = halfWay(owner, owner.node, next), b = halfWay(owner, owner.node, other);
    cover(owner.place, a, b, which == 0u ? halfWay(owner, next, other) : b, true);
}
#endif

void main() {
    uint at = gl_WorkGroupID.x * kCutsPerGroup + gl_LocalInvocationID.y;
    if (at >= cuts) return;
    int width = textureSize(points, 0).x - 1;
    int cell = int(cutTriangles[at] / 2u);
    ivec2 first = ivec2(cell % width, cell / width);
    Corner right = cornerAt(first + int(cutTriangles[at] & 1u)); // at the right angle
    drawPart(Corner[3](right, cornerAt(first + ivec2(0, 1)), cornerAt(first + ivec2(1, 0))));
}
