#version 450 core
// What stands in place of cut triangles. A depth pixel measures a square, not a point: a triangle
// is shared out among its measured corners, each at its own depth as far as the pixels' common
// border. EXTRUDE: at the mesh's border, and at cuts that of the farther surface, a corner's depth
// goes on for so many pixels more, behind all that was measured.
#include "mesh_block.glsl"
#include "camera.glsl"
#include "color_camera.glsl"
#include "registered_keys.glsl"
#include "registered_cover.glsl"
#include "registered_nodes.glsl"
#include "cut_triangles.glsl"

layout(local_size_x = 64, local_size_y = 3) in; // a corner each

#ifdef EXTRUDE
// From the corner at the right angle away from its own square. Every node at a border has one or
// two such triangles, whose other corners were not measured or are cut off, being nearer.
void goOn(Corner owner, Corner a, Corner b) {
    uint nearest = min(a.count, b.count);
    if (nearest >= owner.count || (nearest > 0u && !isCut(nearest, owner.count))) return;
    ivec2 away = a.node + b.node - 2 * owner.node; // (1, 1) or (-1, -1)
    ivec2 last = away * int(counts.w), next = last + away; // its outer edge is half way
    ivec2 at = owner.node, x = ivec2(1, 0), y = ivec2(0, 1);
    vec3 alongX = halfWay(owner, rayAt(at + last * x, at), rayAt(at + next * x, at));
    vec3 alongY = halfWay(owner, rayAt(at + last * y, at), rayAt(at + next * y, at));
    vec3 both = halfWay(owner, rayAt(at + last, at), rayAt(at + next, at));
    cover(owner.place, alongX, alongY, both, false);
}
#endif

// The corner's share: a square at the right angle, else a triangle.
void drawPart(Corner owner, Corner a, Corner b, bool isRight) {
    vec2 own = rayAt(owner.node, owner.node);
    vec2 rayA = rayAt(a.node, owner.node), rayB = rayAt(b.node, owner.node);
    vec3 toA = halfWay(owner, own, rayA), toB = halfWay(owner, own, rayB);
    cover(owner.place, toA, toB, isRight ? halfWay(owner, rayA, rayB) : toB, true);
#ifdef EXTRUDE
    // The edge between two surfaces lies anywhere in a cut triangle: either may reach the other.
    cover(owner.place, halfWay(owner, rayA, rayA), halfWay(owner, rayB, rayB), owner.place, false);
    if (isRight) goOn(owner, a, b);
#endif
}

void main() {
    uint at = gl_WorkGroupID.x * kCutsPerGroup + gl_LocalInvocationID.x;
    if (at >= cuts) return;
    int width = textureSize(places, 0).x - 1;
    int cell = int(cutTriangles[at] / 2u);
    ivec2 first = ivec2(cell % width, cell / width);
    ivec2 nodes[3] = ivec2[3](first + int(cutTriangles[at] & 1u), // at the right angle
                              first + ivec2(0, 1), first + ivec2(1, 0));
    uint which = gl_LocalInvocationID.y;
    Corner owner = cornerAt(nodes[which]);
    if (owner.count > 0u)
        drawPart(owner, cornerAt(nodes[(which + 1u) % 3u]), cornerAt(nodes[(which + 2u) % 3u]),
                 which == 0u);
}
